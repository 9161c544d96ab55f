#include "render/scene/occupied_box.h"

#include <algorithm>

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

/// The count of a layer; what is between it and the counted layers is counted too from now on.
uint32_t& OccupiedBox::Axis::at(int layer) {
    if (counts.empty()) first = layer;
    if (layer < first) {
        const int more = std::max(first - layer, int(counts.size()) / 4);  // so that many small growths move it seldom
        counts.insert(counts.begin(), size_t(more), 0);
        first -= more;
    }
    if (layer - first >= int(counts.size())) counts.resize(size_t(layer - first) + 1, 0);
    return counts[size_t(layer - first)];
}

void OccupiedBox::Axis::add(int layer) {
    if (at(layer)++) return;
    const bool isFirst = low == high;
    low = isFirst ? layer : std::min(low, layer);
    high = isFirst ? layer + 1 : std::max(high, layer + 1);
}

void OccupiedBox::Axis::remove(int layer) {
    if (--at(layer)) return;
    while (low < high && !at(low)) ++low;
    while (low < high && !at(high - 1)) --high;
    if (low == high) *this = {};
}

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
