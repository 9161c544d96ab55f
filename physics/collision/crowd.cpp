#include "physics/collision/crowd.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/bodies/dynamic_body.h"
#include "runtime/core/random.h"

namespace rubble {
namespace {

constexpr uint32_t kMaxDeepPairs = 6;  ///< of a body that does not become crowded
constexpr uint32_t kMaxNearPairs = 2;  ///< of a body that stops being crowded
constexpr uint32_t kKeptPairs = 4;     ///< nearest to a crowded body
constexpr double kNear = 0.7;          ///< half extents of two bodies together at which their centres are near
constexpr double kPushedApart = 0.95;  ///< the same, at which crowded bodies stop pushing each other
constexpr double kMinDistance = 1e-6;  ///< metres between centres with a direction of their own
constexpr float kFriction = 0.5f;

double halfExtents(const CollisionObject& a, const CollisionObject& b) {
    return a.minHalfExtent + b.minHalfExtent;
}

double squaredDistance(const CollisionObject& a, const CollisionObject& b) {
    const glm::dvec3 apart = a.pose.position - b.pose.position;
    return glm::dot(apart, apart);
}

/// Whether a point (world) is in a solid voxel of the object.
bool isInside(const glm::dvec3& point, const CollisionObject& object) {
    for (size_t i = 0; i < object.collider.parts.size(); ++i) {
        const ColliderPart& part = *object.collider.parts[i];
        const CellTransform& cells = object.cellTransforms()[i];
        const glm::dvec3 cell = metresToCells(cells, part.voxelSize()) * (point - object.pose.position - cells.corner);
        if (part.grid().at(cellAt(cell))) return true;
    }
    return false;
}

/// Whether each body has the other's centre of mass in a solid voxel: never true of bodies that hardly overlap, however
/// they are shaped.
bool areDeep(const CollisionObject& a, const CollisionObject& b) {
    return areNear(a, b) && isInside(a.pose.position, b) && isInside(b.pose.position, a);
}

uint64_t numbersOf(const CollisionObject& a, const CollisionObject& b) {
    return uint64_t(std::min(a.number, b.number)) << 32 | std::max(a.number, b.number);
}

}  // namespace

BodyDistance distanceBetween(const CollisionObject& a, const CollisionObject& b) {
    const uint64_t numbers = numbersOf(a, b);
    return {squaredDistance(a, b), uint32_t(Random(numbers).next()), numbers};
}

bool areNear(const CollisionObject& a, const CollisionObject& b) {
    if (!a.dynamic || !b.dynamic) return false;
    const double near = kNear * halfExtents(a, b);
    return squaredDistance(a, b) < near * near;
}

void NearestBodies::add(CollisionObject* other) {
    const bool isFull = m_count == kMax;
    m_leftOut += isFull;
    if (isFull && squaredDistance(*m_object, *other) > m_distances.back().distance2) return;
    const BodyDistance distance = distanceBetween(*m_object, *other);
    if (isFull && !(distance < m_distances.back())) return;
    size_t place = isFull ? kMax - 1 : m_count++;
    for (; place > 0 && distance < m_distances[place - 1]; --place) {
        m_distances[place] = m_distances[place - 1];
        m_bodies[place] = m_bodies[place - 1];
    }
    m_distances[place] = distance;
    m_bodies[place] = other;
}

/// Returns whether any body is crowded.
bool Crowds::mark(const std::vector<ObjectPair>& pairs) {
    for (const auto& [a, b] : pairs) a->crowdPairs = b->crowdPairs = 0;
    for (const auto& [a, b] : pairs) {
        const bool mayEnter =
            (!a->isCrowded && a->crowdPairs <= kMaxDeepPairs) || (!b->isCrowded && b->crowdPairs <= kMaxDeepPairs);
        const bool isNear = areNear(*a, *b), isDeep = isNear && mayEnter && areDeep(*a, *b);
        for (CollisionObject* object : {a, b}) object->crowdPairs += object->isCrowded ? isNear : isDeep;
    }
    bool any = false;
    for (const auto& [a, b] : pairs)
        for (CollisionObject* object : {a, b}) {
            object->isCrowded = object->crowdPairs > (object->isCrowded ? kMaxNearPairs : kMaxDeepPairs);
            any |= object->isCrowded;
        }
    return any;
}

void Crowds::thin(std::vector<ObjectPair>& pairs) {
    if (!mark(pairs)) return;

    // The pairs of each crowded body side by side.
    uint32_t slots = 0;
    for (const auto& [a, b] : pairs)
        if (areCrowded(*a, *b)) slots = std::max({slots, a->number + 1, b->number + 1});
    m_from.assign(slots + 1, 0);
    for (const auto& [a, b] : pairs)
        if (areCrowded(*a, *b)) ++m_from[a->number], ++m_from[b->number];
    size_t sum = 0;
    for (size_t& from : m_from) sum += std::exchange(from, sum);
    m_near.resize(sum);
    std::vector<size_t>& next = m_from;  // moves on to where the next body's begin
    for (size_t i = 0; i < pairs.size(); ++i) {
        const auto& [a, b] = pairs[i];
        if (!areCrowded(*a, *b)) continue;
        const Near near{distanceBetween(*a, *b), i};
        m_near[next[a->number]++] = m_near[next[b->number]++] = near;
    }

    m_isDropped.assign(pairs.size(), false);
    for (const Near& near : m_near) m_isDropped[near.pair] = true;
    for (size_t slot = 0, from = 0; slot < slots; ++slot) {
        const auto begin = m_near.begin() + ptrdiff_t(from), end = m_near.begin() + ptrdiff_t(m_from[slot]);
        const auto kept = begin + std::min<ptrdiff_t>(end - begin, kKeptPairs);
        std::partial_sort(begin, kept, end, [](const Near& a, const Near& b) { return a.distance < b.distance; });
        for (auto near = begin; near != kept; ++near) m_isDropped[near->pair] = false;
        from = m_from[slot];
    }
    size_t count = 0;
    for (size_t i = 0; i < pairs.size(); ++i)
        if (!m_isDropped[i]) pairs[count++] = pairs[i];
    pairs.resize(count);
}

bool areCrowded(const CollisionObject& a, const CollisionObject& b) {
    return a.isCrowded && b.isCrowded;
}

ContactPoint crowdContact(const CollisionObject& first, const CollisionObject& second) {
    glm::dvec3 apart = first.pose.position - second.pose.position;
    const double distance = glm::length(apart);
    if (distance < kMinDistance) {
        Random random(numbersOf(first, second));
        for (int axis = 0; axis < 3; ++axis) apart[axis] = random.unit() - 0.5;
    }
    ContactPoint contact;
    contact.normal = glm::vec3(glm::normalize(apart));
    contact.position = glm::vec3((second.pose.position - first.pose.position) * 0.5);
    contact.separation = float(distance - kPushedApart * halfExtents(first, second));
    contact.friction = kFriction;
    return contact;
}

}  // namespace rubble
