#include "render/gl/offscreen.h"

#include <algorithm>

#include "render/gl/state_guard.h"

namespace rubble {

Offscreen::Offscreen(glm::ivec2 size) : m_color(GL_RGBA8, size), m_framebuffer({&m_color}) {}

std::vector<uint8_t> Offscreen::readRgb() const {
    const size_t count = size_t(size().x) * size_t(size().y), rowBytes = size_t(size().x) * 3;
    std::vector<uint8_t> pixels(4 * count);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer());
    const PixelPackGuard packing;
    glReadPixels(0, 0, size().x, size().y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());  // as OpenGL ES does, too
    for (size_t i = 0; i < count; ++i) std::copy_n(&pixels[4 * i], 3, &pixels[3 * i]);
    pixels.resize(3 * count);
    for (int top = 0, bottom = size().y - 1; top < bottom; ++top, --bottom)
        std::swap_ranges(pixels.begin() + long(rowBytes) * top, pixels.begin() + long(rowBytes) * (top + 1),
                         pixels.begin() + long(rowBytes) * bottom);
    return pixels;
}

}  // namespace rubble
