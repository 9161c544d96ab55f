#pragma once
#include <cstdint>
#include <vector>

#include "render/gl/framebuffer.h"

namespace rubble {

/// A framebuffer to draw a view into where there is no window. [render-thread]
class Offscreen {
public:
    /// In pixels.
    explicit Offscreen(glm::ivec2 size);
    /// For View::framebuffer.
    unsigned framebuffer() const { return m_framebuffer.name(); }
    /// In pixels.
    glm::ivec2 size() const { return m_color.size(); }
    /// Its image as 8-bit RGB, rows from the top. Waits for the GL.
    std::vector<uint8_t> readRgb() const;

private:
    Texture m_color;
    Framebuffer m_framebuffer;
};

}  // namespace rubble
