#include "physics/collision/broadphase.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

constexpr double kRounding = 1e-4;  ///< metres added to bounds against the rounding of their floats

}  // namespace

void Broadphase::sortPairs(std::vector<ObjectPair>& pairs, size_t from) {
    std::sort(pairs.begin() + std::ptrdiff_t(from), pairs.end(), [](const ObjectPair& a, const ObjectPair& b) {
        return a.first->number != b.first->number ? a.first->number < b.first->number
                                                  : a.second->number < b.second->number;
    });
}

/// A moving object is bounded by its parts' hulls, one at rest by their boxes, whose computation touches no voxels.
void Broadphase::setBounds(CollisionObject& object, glm::dvec3 displacement, double margin) const {
    glm::dvec3 low(1e30), high(-1e30);
    for (size_t i = 0; i < object.m_cellTransforms.size(); ++i) {
        const ColliderPart& part = *object.collider.parts[i];
        if (part.grid().empty()) continue;
        const glm::mat3 axes(object.m_cellTransforms[i].axes);
        glm::vec3 partLow, partHigh;
        if (object.m_moves)
            part.hull().bounds(axes, partLow, partHigh);
        else
            HullPoints(part.bounds()).bounds(axes, partLow, partHigh);
        low = glm::min(low, object.m_cellTransforms[i].corner + glm::dvec3(partLow));
        high = glm::max(high, object.m_cellTransforms[i].corner + glm::dvec3(partHigh));
    }
    object.low = object.pose.position + low - margin - kRounding + glm::min(displacement, 0.0);
    object.high = object.pose.position + high + margin + kRounding + glm::max(displacement, 0.0);
}

void Broadphase::add(CollisionObject& object, bool moves) {
    object.m_moves = moves;
    setBounds(object, glm::dvec3(0.0), 0.0);
    touch(object);
    if (m_freeItems.empty()) {
        object.m_item = uint32_t(m_objects.size());
        m_objects.push_back(&object);
    } else {
        object.m_item = m_freeItems.back();
        m_freeItems.pop_back();
        m_objects[object.m_item] = &object;
    }
    m_tree.update(object.m_item, {object.low, object.high});
}

void Broadphase::remove(CollisionObject& object) {
    if (object.m_item == CollisionObject::kNoItem) return;
    m_tree.remove(object.m_item);
    m_freeItems.push_back(std::exchange(object.m_item, CollisionObject::kNoItem));
}

void Broadphase::move(CollisionObject& object, glm::dvec3 displacement, double margin) {
    setBounds(object, displacement, margin);
    m_tree.update(object.m_item, {object.low, object.high});
}

void Broadphase::find(glm::dvec3 low, glm::dvec3 high, std::vector<CollisionObject*>& out) {
    const WorldBox around{low, high};
    const auto add = [&](uint32_t item) {
        CollisionObject* object = m_objects[item];
        if (around.overlaps({object->low, object->high})) out.push_back(object);
    };
    m_tree.find([&](const WorldBox& box) { return box.overlaps(around); }, add, m_open);
}

}  // namespace rubble
