#include "editor/ui/gl/gl_surface.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "render/gl/gl.h"
#include "render/gl/offscreen.h"
#include "samples/support/gl_context.h"
#include "samples/support/image.h"

namespace editor {

std::string loadGlFunctions(GlLoader loader) {
    const auto loaded = rubble::loadGl(loader);
    return loaded ? "" : loaded.error();
}

GlImage::GlImage() {
    glGenTextures(1, &m_texture);
    glGenFramebuffers(1, &m_framebuffer);
}

GlImage::~GlImage() {
    glDeleteFramebuffers(1, &m_framebuffer);
    glDeleteTextures(1, &m_texture);
}

void GlImage::resize(int width, int height) {
    m_width = width, m_height = height;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, m_texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("the view's framebuffer is not complete");
}

std::string GlImage::write(const std::string& path) const {
    const size_t row = size_t(m_width) * 3;
    std::vector<uint8_t> pixels(row * size_t(m_height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, m_width, m_height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    rubble::Image image(m_width, m_height);
    for (int y = 0; y < m_height; ++y)  // the first row is at the bottom
        std::copy_n(pixels.data() + size_t(m_height - 1 - y) * row, row, image.rgb.data() + size_t(y) * row);
    const auto written = rubble::writePng(path, image);
    return written ? "" : written.error();
}

struct OffscreenGl::Parts {
    std::unique_ptr<rubble::GlContext> context;
    std::optional<rubble::Offscreen> target;
};

OffscreenGl::OffscreenGl(int width, int height) : m_parts(std::make_unique<Parts>()) {
    auto context = rubble::GlContext::create();
    if (!context) throw std::runtime_error(context.error());
    m_parts->context = std::move(context).value();
    if (const std::string error = loadGlFunctions(loader()); !error.empty()) throw std::runtime_error(error);
    m_parts->target.emplace(glm::ivec2(width, height));
}

OffscreenGl::~OffscreenGl() = default;

GlLoader OffscreenGl::loader() const {
    return m_parts->context->loader();
}

uint32_t OffscreenGl::framebuffer() const {
    return m_parts->target->framebuffer();
}

std::string OffscreenGl::write(const std::string& path) const {
    rubble::Image image(m_parts->target->size().x, m_parts->target->size().y);
    image.rgb = m_parts->target->readRgb();
    const auto written = rubble::writePng(path, image);
    return written ? "" : written.error();
}

}  // namespace editor
