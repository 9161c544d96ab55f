#include "render/gl/framebuffer.h"

#include "render/gl/draw_state.h"
#include "runtime/core/assertion.h"

namespace rubble {

Framebuffer::Framebuffer(const std::vector<const Texture*>& colors, const Texture* depth)
    : m_name(GlName<FramebufferKind>::make()) {
    m_size = colors.empty() ? depth->size() : colors[0]->size();
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    std::vector<GLenum> buffers;
    for (const Texture* color : colors) {
        RUBBLE_ASSERT(color->size() == m_size && "attachments differ in size");
        const GLenum attachment = GLenum(GL_COLOR_ATTACHMENT0 + buffers.size());
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, color->name(), 0);
        buffers.push_back(attachment);
    }
    if (depth) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth->name(), 0);
    if (buffers.empty()) {
        buffers.push_back(GL_NONE);
        glReadBuffer(GL_NONE);  // before GL 4.1 a framebuffer is incomplete whose read buffer has no attachment
    }
    glDrawBuffers(GLsizei(buffers.size()), buffers.data());
    m_isComplete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void Framebuffer::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, name());
    setViewport(m_size);
}

}  // namespace rubble
