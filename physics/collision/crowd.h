#pragma once
#include <array>
#include <compare>
#include <span>
#include <vector>

#include "physics/bodies/collision_object.h"
#include "physics/collision/voxel_contacts.h"

namespace rubble {

/// How near one body is to another: by the distance of their centres, then in a random order that is always the same.
struct BodyDistance {
    double distance2;  ///< m2
    uint32_t random;
    uint64_t numbers;  ///< of the two
    auto operator<=>(const BodyDistance&) const = default;
};
/// The distance of two bodies; symmetric.
BodyDistance distanceBetween(const CollisionObject& a, const CollisionObject& b);
/// Whether the centres of two bodies are so near that the bodies overlap deeply; false of what is static.
bool areNear(const CollisionObject& a, const CollisionObject& b);

/// The 16 bodies that are nearest to one.
class NearestBodies {
public:
    /// Forgets all, and measures from `object` on.
    void begin(CollisionObject* object) { m_object = object, m_count = m_leftOut = 0; }
    /// The one that they are near to.
    CollisionObject* object() const { return m_object; }
    /// Takes a body in if it is one of the nearest so far.
    void add(CollisionObject* other);
    /// Those taken in, the nearest first.
    std::span<CollisionObject* const> all() const { return {m_bodies.data(), m_count}; }
    /// How many were added that are not among them.
    size_t leftOut() const { return m_leftOut; }

private:
    static constexpr size_t kMax = 16;
    CollisionObject* m_object = nullptr;
    size_t m_count = 0, m_leftOut = 0;
    std::array<BodyDistance, kMax> m_distances;
    std::array<CollisionObject*, kMax> m_bodies;
};

/// Things that were put into the same place, many deep in many others: n of them are n^2 pairs, and each pair of deep
/// bodies has contacts all over. Such bodies push each other apart as if they were spheres, each those nearest to it
/// only, until they are not so crowded any more.
class Crowds {
public:
    /// Marks the crowded bodies of the pairs, and drops the pairs of two crowded bodies that are not among the nearest
    /// of either. Keeps the order.
    void thin(std::vector<ObjectPair>& pairs);

private:
    static bool mark(const std::vector<ObjectPair>& pairs);

    struct Near {
        BodyDistance distance;
        size_t pair;
    };
    std::vector<size_t> m_from;  ///< by slot: where a crowded body's pairs begin in m_near
    std::vector<Near> m_near;
    std::vector<bool> m_isDropped;  ///< by pair
};

/// Whether the two are crowded, as marked by Crowds::thin().
bool areCrowded(const CollisionObject& a, const CollisionObject& b);
/// The contact of two bodies in a crowd.
ContactPoint crowdContact(const CollisionObject& first, const CollisionObject& second);

}  // namespace rubble
