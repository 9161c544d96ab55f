#include "render/scene/dirty_regions.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

namespace rubble {
namespace {

/// Bricks between a brick and a box along the axis where they are farthest apart; 0 if they touch.
int chebyshevDistance(const DirtyRegions::Box& box, glm::ivec3 brick) {
    const glm::ivec3 gap = glm::max(glm::max(box.low - brick - 1, brick - box.high), glm::ivec3(0));
    return std::max(gap.x, std::max(gap.y, gap.z));
}

}  // namespace

void DirtyRegions::add(glm::ivec3 brick) {
    Box* nearest = nullptr;
    int smallest = std::numeric_limits<int>::max();
    for (Box& box : m_boxes)
        if (const int distance = chebyshevDistance(box, brick); distance < smallest)
            smallest = distance, nearest = &box;
    if (!nearest || (smallest > 0 && m_boxes.size() < kMaxRegions)) {
        m_boxes.push_back({brick, brick + 1});
        return;
    }
    nearest->low = glm::min(nearest->low, brick);
    nearest->high = glm::max(nearest->high, brick + 1);
}

void DirtyRegions::add(const std::vector<ShadowPatch>& patches) {
    for (const ShadowPatch& patch : patches) add(patch.brick);
}

DirtyRegions DirtyRegions::begin(const DirtyRegions& last) const {
    DirtyRegions begun = *this;
    begun.m_followOthers = !last.m_boxes.empty();
    return begun;
}

}  // namespace rubble
