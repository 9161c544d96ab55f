#include "physics/collision/broadphase.h"

#include <algorithm>
#include <cmath>

#include "physics/math/bullet_math.h"

namespace rubble {
namespace {

/// Metres by which the leaf of a moving object is larger than its bounds, so that small moves do not change the tree.
constexpr btScalar kFatMargin = 0.05f;
constexpr double kRounding = 1e-4;  ///< metres added to bounds against the rounding of their floats

}  // namespace

bool Broadphase::overlap(const CollisionObject& a, const CollisionObject& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
}

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

btDbvtVolume Broadphase::volumeOf(glm::dvec3 low, glm::dvec3 high) const {
    return btDbvtVolume::FromMM(toBullet(low - m_origin), toBullet(high - m_origin));
}

void Broadphase::add(CollisionObject& object, bool moves) {
    object.m_moves = moves;
    setBounds(object, glm::dvec3(0.0), 0.0);
    touch(object);
    object.m_leaf = (moves ? m_moving : m_resting).insert(volumeOf(object.low, object.high), &object);
}

void Broadphase::remove(CollisionObject& object) {
    if (!object.m_leaf) return;
    (object.m_moves ? m_moving : m_resting).remove(object.m_leaf);
    object.m_leaf = nullptr;
}

void Broadphase::move(CollisionObject& object, glm::dvec3 displacement, double margin) {
    setBounds(object, displacement, margin);
    btDbvtVolume volume = volumeOf(object.low, object.high);
    m_moving.update(object.m_leaf, volume, btVector3(0, 0, 0), kFatMargin);
}

void Broadphase::find(glm::dvec3 low, glm::dvec3 high, std::vector<CollisionObject*>& out) {
    struct Collect : btDbvt::ICollide {
        explicit Collect(std::vector<CollisionObject*>& found) : objects(found) {}
        void Process(const btDbvtNode* leaf) override { objects.push_back(static_cast<CollisionObject*>(leaf->data)); }
        std::vector<CollisionObject*>& objects;
    } collect(out);
    const btDbvtVolume volume = volumeOf(low, high);
    for (btDbvt* tree : {&m_resting, &m_moving}) tree->collideTVNoStackAlloc(tree->m_root, volume, m_stack, collect);
}

}  // namespace rubble
