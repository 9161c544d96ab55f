#include "physics/collider.h"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <algorithm>

#include "physics/bullet_math.h"

namespace rubble {

Collider::Collider(const std::vector<ColliderBox>& boxes) {
    m_boxes.reserve(boxes.size());  // the compound points into it
    for (const ColliderBox& box : boxes) m_boxes.emplace_back(toBullet(box.halfSize));
    if (boxes.size() == 1 && glm::length(boxes[0].place.position) < 1e-6 && std::abs(boxes[0].place.rotation.w) > 1.0 - 1e-12) return;
    m_compound.emplace(true, int(boxes.size()));
    for (size_t i = 0; i < boxes.size(); ++i) m_compound->addChildShape(toBullet(boxes[i].place, glm::dvec3(0.0)), &m_boxes[i]);
    if (boxes.size() > 8) m_compound->getDynamicAabbTree()->optimizeTopDown();
}

void appendBoxes(const std::vector<CellBox>& cells, double voxelSize, const Pose& frame, std::vector<ColliderBox>& out) {
    out.reserve(out.size() + cells.size());
    for (const CellBox& box : cells) {
        const glm::dvec3 center = glm::dvec3(box.low + box.high) * (0.5 * voxelSize);
        out.push_back({{frame.transformPoint(center), frame.rotation}, glm::dvec3(box.high - box.low) * (0.5 * voxelSize)});
    }
}

void SurfaceSum::add(const Brick& brick, const Palette& palette, const MaterialTable& materials) {
    const auto addEntry = [&](uint8_t entry, uint64_t count) {
        const uint8_t material = palette[entry].material;
        m_weight[material] += count * materials[material].density;
    };
    if (!brick.indices) return addEntry(brick.uniform, uint64_t(brick.count()));
    forEachVoxel(brick.occupancy, [&](int i) { addEntry((*brick.indices)[size_t(i)], 1); });
}

const Material& SurfaceSum::dominant(const MaterialTable& materials) const {
    return materials[uint8_t(std::max_element(m_weight.begin(), m_weight.end()) - m_weight.begin())];
}

}  // namespace rubble
