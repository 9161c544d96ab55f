#pragma once
#include <cstdint>
#include <vector>

#include "render/gl/framebuffer.h"

namespace rubble {

/// A framebuffer of its own to draw a view into when there is no window, and the way back to main memory.
class Offscreen {
public:
    explicit Offscreen(glm::ivec2 size);
    unsigned framebuffer() const { return m_framebuffer.name(); }
    glm::ivec2 size() const { return m_color.size(); }
    /// 8-bit RGB, rows from the top.
    std::vector<uint8_t> readRgb() const;

private:
    Texture m_color;
    Framebuffer m_framebuffer;
};

}  // namespace rubble
