#include "render/passes/sampler_reset.h"

#include "render/gl/draw_state.h"

namespace rubble {

SamplerReset::SamplerReset(ShaderLibrary& shaders) : m_program(shaders.load("passes/sampler_reset.frag")) {}

void SamplerReset::draw(const Texture& any, const VertexArray& empty) const {
    if (!m_program) return;
    glBindFramebuffer(GL_FRAMEBUFFER, m_target.framebuffer());
    setViewport(m_target.size());
    m_program.use();
    m_program.set("uAny[0]", any);
    bindForUpload(any.target(), any.name());  // the unit of the array's other elements
    glBindVertexArray(empty.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace rubble
