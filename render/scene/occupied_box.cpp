#include "render/scene/occupied_box.h"

namespace rubble {
namespace {

constexpr int kLayers = 4;  ///< words of a brick along an axis

/// Bit i: whether layer i along the axis holds a word of the set.
uint32_t layersOf(uint64_t words, size_t axis) {
    constexpr uint64_t kLayer[] = {0x1111111111111111, 0x000f000f000f000f, 0x000000000000ffff};
    uint32_t out = 0;
    for (size_t i = 0; i < kLayers; ++i) out |= uint32_t((words & kLayer[axis] << (i << (2 * axis))) != 0) << i;
    return out;
}

}  // namespace

void OccupiedBox::change(glm::ivec3 brick, uint64_t before, uint64_t after) {
    for (size_t axis = 0; axis < m_axes.size(); ++axis) {
        const uint32_t was = layersOf(before, axis), is = layersOf(after, axis);
        for (int i = 0; i < kLayers; ++i)
            if (is & ~was & 1u << i) m_axes[axis].add(brick[int(axis)] * kLayers + i);
        for (int i = 0; i < kLayers; ++i)
            if (was & ~is & 1u << i) m_axes[axis].remove(brick[int(axis)] * kLayers + i);
    }
}

}  // namespace rubble
