#pragma once
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace rubble {

/// The pixels from `low` to below `high`.
struct PixelRect {
    glm::ivec2 low{0}, high{0};

    /// Whether there are none.
    bool empty() const { return low.x >= high.x || low.y >= high.y; }
    /// How many there are.
    uint64_t pixels() const { return empty() ? 0 : uint64_t(high.x - low.x) * uint64_t(high.y - low.y); }
    /// Width and height.
    glm::ivec2 size() const { return high - low; }
    /// Whether they have a pixel in common.
    bool overlaps(const PixelRect& other) const {
        return !PixelRect{glm::max(low, other.low), glm::min(high, other.high)}.empty();
    }
    /// The smallest one that holds both. An empty one adds nothing.
    PixelRect merged(const PixelRect& other) const {
        if (empty() || other.empty()) return empty() ? other : *this;
        return {glm::min(low, other.low), glm::max(high, other.high)};
    }
};

}  // namespace rubble
