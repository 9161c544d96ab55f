#include "render/scene/dirty_regions.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

namespace rubble {
namespace {

/// Bricks between a brick and a box: 0 if they touch.
int chebyshevDistance(const DirtyRegions::Box& box, glm::ivec3 brick) {
    const glm::ivec3 away = glm::max(glm::max(box.low - brick - 1, brick - box.high), glm::ivec3(0));
    return std::max(away.x, std::max(away.y, away.z));
}

}  // namespace

void DirtyRegions::add(glm::ivec3 brick) {
    Box* nearest = nullptr;
    int least = std::numeric_limits<int>::max();
    for (Box& box : m_boxes)
        if (const int distance = chebyshevDistance(box, brick); distance < least) least = distance, nearest = &box;
    if (!nearest || (least > 0 && m_boxes.size() < kMaxRegions)) {
        m_boxes.push_back({brick, brick + 1});
        return;
    }
    nearest->low = glm::min(nearest->low, brick);
    nearest->high = glm::max(nearest->high, brick + 1);
}

void DirtyRegions::add(const std::vector<ShadowPatch>& patches) {
    for (const ShadowPatch& patch : patches) add(patch.brick);
}

}  // namespace rubble
