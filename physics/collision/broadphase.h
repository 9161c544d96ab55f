#pragma once
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <span>
#include <utility>
#include <vector>

#include "physics/collision/voxel_contacts.h"

namespace rubble {

class DynamicBody;

inline constexpr uint32_t kStaticObject = 0x80000000u;  ///< in the number of an object that stands still for good

/// What can be touched: the voxels of a body, or one shape of a static body, at their setPose.
struct CollisionObject {
    VoxelCollider collider;
    Pose pose;            ///< collider's frame -> world
    double radius = 0.0;  ///< of the collider about its frame's origin, metres
    uint32_t body = 0;    ///< slot
    uint32_t number = 0;  ///< unique; the order of pairs: a body's slot, or a static shape's with kStaticObject
    DynamicBody* dynamic = nullptr;  ///< null: static
    bool isNew = true;  ///< has another mass or form than in the last step: its contacts inheritImpulses no impulses
    CollisionFilter filter;          ///< of all parts together, as of the last setPose()
    glm::dvec3 low{0.0}, high{0.0};  ///< world bounds, with what it sweeps in the step
    uint32_t version = 0;            ///< another one after it was added anew or its voxels changed

    /// Puts it at a setPose; the broadphase is told with Broadphase::move().
    void setPose(const Pose& at);
    std::span<const CellTransform> cellTransforms() const { return m_cellTransforms; }

private:
    friend class Broadphase;
    std::vector<CellTransform> m_cellTransforms;  ///< of the collider's parts
    btDbvtNode* m_leaf = nullptr;
    bool m_moves = false;
};

using ObjectPair = std::pair<CollisionObject*, CollisionObject*>;

/// Which objects are near each other: two of Bullet's dynamic trees of bounds, one of what moves and one of what rests.
/// Nothing is kept about pairs, so what rests costs nothing and removing it costs the depth of a tree.
class Broadphase {
public:
    /// World position of Bullet's zero: it counts in toFloat4.
    void setOrigin(glm::dvec3 origin) { m_origin = origin; }
    glm::dvec3 origin() const { return m_origin; }

    void add(CollisionObject& object, bool moves);
    void remove(CollisionObject& object);
    /// Its voxels have changed where it is.
    void touch(CollisionObject& object) { object.version = ++m_versions; }
    /// The object has moved: its bounds are those of its pose, widened by `margin` and by its displacement (metres,
    /// world).
    void move(CollisionObject& object, glm::dvec3 displacement, double margin);

    /// Objects whose bounds may overlap a box, in no order.
    void find(glm::dvec3 low, glm::dvec3 high, std::vector<CollisionObject*>& out);
    /// Pairs of these objects, which move, with others and each other, each pair once, the one with the lower number
    /// first; sorted. Pairs with what moves and `isKnown` are left out.
    template <class IsKnown>
    void findPairs(std::span<CollisionObject* const> moving, IsKnown&& isKnown, std::vector<ObjectPair>& out) {
        const size_t from = out.size();
        for (CollisionObject* object : moving) {
            m_found.clear();
            find(object->low, object->high, m_found);
            for (CollisionObject* other : m_found) {
                if (other == object || !object->filter.meets(other->filter) || !overlap(*object, *other)) continue;
                if (other->m_moves && (isKnown(*other) || other->number < object->number)) continue;
                out.emplace_back(object->number < other->number ? ObjectPair(object, other)
                                                                : ObjectPair(other, object));
            }
        }
        sortPairs(out, from);
    }

private:
    static bool overlap(const CollisionObject& a, const CollisionObject& b);
    static void sortPairs(std::vector<ObjectPair>& pairs, size_t from);
    void setBounds(CollisionObject& object, glm::dvec3 displacement, double margin) const;
    btDbvtVolume volumeOf(glm::dvec3 low, glm::dvec3 high) const;

    glm::dvec3 m_origin{0.0};
    btDbvt m_moving, m_resting;
    btAlignedObjectArray<const btDbvtNode*> m_stack;
    std::vector<CollisionObject*> m_found;
    uint32_t m_versions = 0;
};

}  // namespace rubble
