#include "physics/collider.h"

#include <LinearMath/btAabbUtil2.h>

#include <algorithm>

#include "physics/bullet_math.h"

namespace rubble {

Bounds Bounds::seenThrough(const btTransform& transform) const {
    Bounds out;
    btTransformAabb(low, high, btScalar(0), transform, out.low, out.high);
    return out;
}

Collider::Collider(const std::vector<ColliderBox>& boxes) {
    m_boxes.reserve(boxes.size());  // the parts and the compound point into it
    m_parts.reserve(boxes.size());
    m_bounds.reserve(boxes.size());
    for (const ColliderBox& box : boxes) {
        Part part;
        part.box = &m_boxes.emplace_back(toBullet(box.halfSize));
        part.place = toBullet(box.place, glm::dvec3(0.0));
        m_parts.push_back(part);
        Bounds& bounds = m_bounds.emplace_back();
        part.box->getAabb(part.place, bounds.low, bounds.high);
        if (m_parts.size() == 1) m_all = bounds;
        m_all.include(bounds);
    }
    const bool plain = boxes.size() == 1 && glm::length(boxes[0].place.position) < 1e-6 && std::abs(boxes[0].place.rotation.w) > 1.0 - 1e-12;
    if (!plain) {
        m_compound.emplace(false, int(boxes.size()));
        for (size_t i = 0; i < boxes.size(); ++i) m_compound->addChildShape(m_parts[i].place, &m_boxes[i]);
    }
    if (!boxes.empty()) shape()->setUserPointer(this);
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
