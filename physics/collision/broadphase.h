#pragma once
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <span>
#include <utility>
#include <vector>

#include "physics/bodies/collision_object.h"
#include "physics/collision/crowd.h"

namespace rubble {

/// Finds which objects are near each other with two of Bullet's dynamic bounding volume trees: one of objects that
/// move, one of objects at rest. No pairs are kept from step to step, so what rests costs nothing, and removing it
/// costs the depth of a tree. [main-thread]
class Broadphase {
public:
    /// The world position of Bullet's origin. Bullet's bounds are floats, so choose it near the level's middle; before
    /// the first add().
    void setOrigin(glm::dvec3 origin) { m_origin = origin; }
    /// See setOrigin().
    glm::dvec3 origin() const { return m_origin; }

    /// Adds an object at its pose; it must stay at its address until it is removed. moves: it is awake.
    void add(CollisionObject& object, bool moves);
    /// Notes that an object has woken or fallen asleep. Its cached contacts remain.
    void setMoving(CollisionObject& object, bool moves);
    /// Removes an object; does nothing if it is in no tree.
    void remove(CollisionObject& object);
    /// Notes that the object's voxels or filter have changed: cached contacts are dropped.
    void touch(CollisionObject& object) { object.version = ++m_versions; }
    /// Computes the bounds of a moving object at its pose, widened by `margin` on all sides and by its displacement in
    /// the step (metres, world axes).
    void move(CollisionObject& object, glm::dvec3 displacement, double margin);

    /// Nodes on the longest path from the root of either tree.
    int depth() const;

    /// Appends the objects whose bounds overlap a box (world, metres), in no particular order.
    void find(glm::dvec3 low, glm::dvec3 high, std::vector<CollisionObject*>& out);
    /// Appends the pairs of the `moving` objects with each other and with all others whose bounds overlap at some time
    /// of the step: each pair once, sorted by numbers. isKnown: called for other moving objects; pairs with those for
    /// which it is true are left out. So are pairs of bodies that are deep in each other but not among the 16 nearest
    /// of either; returns how many each body left out, in sum.
    template <class IsKnown>
    size_t findPairs(std::span<CollisionObject* const> moving, IsKnown&& isKnown, std::vector<ObjectPair>& out) {
        const size_t from = out.size();
        size_t leftOut = 0;
        for (CollisionObject* object : moving) {
            m_found.clear();
            m_near.clear();
            find(object->low, object->high, m_found);
            const size_t own = out.size();
            for (CollisionObject* other : m_found) {
                if (other == object || !object->filter.meets(other->filter) || !meet(*object, *other)) continue;
                if (other->m_moves && isKnown(*other)) continue;
                if (areNear(*object, *other))
                    m_near.push_back({distanceBetween(*object, *other), other});
                else if (!other->m_moves || object->number < other->number)
                    out.push_back(inOrder(object, other));
            }
            leftOut += addNearest(object, out);
            sortPairs(out, own);
        }
        sortPairs(out, from);
        return leftOut;
    }

private:
    /// One of Bullet's trees, kept shallow.
    struct Tree {
        btDbvt nodes;
        int64_t excess = 0;  ///< visits of insertions beyond those of a shallow tree, since the tree was built

        /// Rebuilds the tree from top down if the leaf and those before it were inserted too deep: see the .cpp.
        void keepShallow(const btDbvtNode* inserted);
    };
    static ObjectPair inOrder(CollisionObject* a, CollisionObject* b) {
        return a->number < b->number ? ObjectPair(a, b) : ObjectPair(b, a);
    }
    size_t addNearest(CollisionObject* object, std::vector<ObjectPair>& out);
    static bool meet(const CollisionObject& a, const CollisionObject& b);
    static void sortPairs(std::vector<ObjectPair>& pairs, size_t from);
    void insert(CollisionObject& object, bool moves);
    void setBounds(CollisionObject& object, glm::dvec3 displacement, double margin) const;
    btDbvtVolume volumeOf(glm::dvec3 low, glm::dvec3 high) const;
    btDbvtVolume scatteredVolumeOf(const CollisionObject& object) const;
    Tree& treeOf(const CollisionObject& object) { return object.m_moves ? m_moving : m_resting; }

    glm::dvec3 m_origin{0.0};
    Tree m_moving, m_resting;
    btAlignedObjectArray<const btDbvtNode*> m_stack;
    std::vector<CollisionObject*> m_found;
    std::vector<std::pair<BodyDistance, CollisionObject*>> m_near;  ///< deep in the object whose pairs are searched
    uint32_t m_versions = 0;
};

}  // namespace rubble
