#pragma once
#include <span>
#include <vector>

#include "physics/bodies/collision_object.h"
#include "runtime/core/bounds_tree.h"

namespace rubble {

/// Finds which objects are near each other with a tree of their bounds. No pairs are kept from step to step, so what
/// rests costs nothing, and adding or removing it costs the depth of the tree. [main-thread]
class Broadphase {
public:
    /// Adds an object at its pose; it must stay at its address until it is removed. moves: it is awake.
    void add(CollisionObject& object, bool moves);
    /// Removes an object; does nothing if it is not there.
    void remove(CollisionObject& object);
    /// Notes that the object's voxels or filter have changed: cached contacts are dropped.
    void touch(CollisionObject& object) { object.version = ++m_versions; }
    /// Computes the bounds of a moving object at its pose, widened by `margin` on all sides and by its displacement in
    /// the step (metres, world axes).
    void move(CollisionObject& object, glm::dvec3 displacement, double margin);

    /// Nodes on the longest path of the tree.
    int depth() const { return m_tree.depth(); }
    /// Appends the objects whose bounds overlap a box (world, metres), in no particular order.
    void find(glm::dvec3 low, glm::dvec3 high, std::vector<CollisionObject*>& out);
    /// Appends the overlapping pairs of the `moving` objects with each other and with all others: each pair once,
    /// sorted by numbers. isKnown: called for other moving objects; pairs with those for which it is true are left out.
    template <class IsKnown>
    void findPairs(std::span<CollisionObject* const> moving, IsKnown&& isKnown, std::vector<ObjectPair>& out) {
        const size_t from = out.size();
        for (CollisionObject* object : moving) {
            m_found.clear();
            find(object->low, object->high, m_found);
            for (CollisionObject* other : m_found) {
                if (other == object || !object->filter.meets(other->filter)) continue;
                if (other->m_moves && (isKnown(*other) || other->number < object->number)) continue;
                out.emplace_back(object->number < other->number ? ObjectPair(object, other)
                                                                : ObjectPair(other, object));
            }
        }
        sortPairs(out, from);
    }

private:
    static constexpr double kMargin = 0.05;  ///< metres by which a leaf is larger: small moves do not change the tree
    static void sortPairs(std::vector<ObjectPair>& pairs, size_t from);
    void setBounds(CollisionObject& object, glm::dvec3 displacement, double margin) const;

    BoundsTree m_tree{kMargin};
    std::vector<CollisionObject*> m_objects;  ///< by item of the tree
    std::vector<uint32_t> m_freeItems, m_open;
    std::vector<CollisionObject*> m_found;
    uint32_t m_versions = 0;
};

}  // namespace rubble
