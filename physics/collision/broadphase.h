#pragma once
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>
#include <utility>
#include <vector>

#include "physics/bodies/collision_object.h"
#include "physics/collision/crowd.h"
#include "physics/collision/packed_boxes.h"

namespace rubble {

/// Finds which objects are near each other with two of Bullet's dynamic bounding volume trees: one of objects that
/// move, one of objects at rest. No pairs are kept from step to step, so what rests costs nothing, and removing it
/// costs the depth of a tree. Pairs of what moves come from a tree of their own, built in every step. [main-thread]
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
    /// Computes the bounds of an object at its pose, widened by `margin` on all sides and by its displacement in the
    /// step (metres, world axes). move() is to follow. [any thread]
    void setBounds(CollisionObject& object, glm::dvec3 displacement, double margin) const;
    /// Notes that a moving object has new bounds.
    void move(CollisionObject& object);

    /// Nodes on the longest path from the root of either tree.
    int depth() const;

    /// Appends the objects whose bounds overlap a box (world, metres), in no particular order.
    void find(glm::dvec3 low, glm::dvec3 high, std::vector<CollisionObject*>& out);
    /// Appends the pairs of these objects, which move, with each other and with all at rest whose bounds overlap at
    /// some time of the step: each pair once, sorted by numbers. Pairs of bodies that are deep in each other, or both
    /// crowded (see Crowds), but not among the 16 nearest of either are left out; returns how many each body left out,
    /// in sum.
    size_t findPairs(std::span<CollisionObject* const> moving, std::vector<ObjectPair>& out);

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
    void findIn(const Tree& tree, glm::dvec3 low, glm::dvec3 high, std::vector<CollisionObject*>& out);
    /// The boxes that two objects sweep may overlap although one has passed long before the other comes. Those boxes
    /// are taken for what moves less than its size.
    static bool meet(const CollisionObject& a, const CollisionObject& b) {
        const glm::dvec3 path = a.displacement - b.displacement;
        const double size = 2.0 * std::min(a.radius, b.radius);
        return glm::dot(path, path) <= size * size || boundsMeet(a, b);
    }
    static bool boundsMeet(const CollisionObject& a, const CollisionObject& b);
    NearestBodies& nearestTo(CollisionObject* object);
    void addPair(CollisionObject* a, CollisionObject* b);
    void sortPairs(size_t moving, std::vector<ObjectPair>& out);
    void insert(CollisionObject& object, bool moves);
    btDbvtVolume volumeOf(glm::dvec3 low, glm::dvec3 high) const;
    btDbvtVolume scatteredVolumeOf(const CollisionObject& object) const;
    Tree& treeOf(const CollisionObject& object) { return object.m_moves ? m_moving : m_resting; }

    glm::dvec3 m_origin{0.0};
    Tree m_moving, m_resting;
    std::vector<const btDbvtNode*> m_stack;  ///< that find() still visits
    std::vector<CollisionObject*> m_found;
    PackedBoxes m_packed;  ///< bounds of the objects whose pairs are searched
    std::vector<WorldBox> m_bounds;
    std::vector<std::pair<uint32_t, uint32_t>> m_indices;  ///< of those whose bounds overlap
    std::vector<ObjectPair> m_unsorted;
    std::vector<size_t> m_ends;  ///< by moving object: where its pairs end
    std::vector<NearestBodies> m_nearest;
    std::vector<uint32_t> m_nearestOf;  ///< by moving object: 1 + its place in m_nearest; 0: none
    uint32_t m_usedNearest = 0;
    uint32_t m_versions = 0;
};

}  // namespace rubble
