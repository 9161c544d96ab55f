#include "physics/collision/crowd.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "physics/bodies/dynamic_body.h"
#include "runtime/core/random.h"

namespace rubble {
namespace {

constexpr uint32_t kMaxDeepPairs = 6;  ///< of a body that is not crowded: a block of cubes at rest has six neighbours
constexpr uint32_t kKeptPairs = 4;     ///< nearest to a crowded body
constexpr double kDeepShare = 0.95;    ///< of the half extents of two bodies, at which their centres are deep
constexpr double kMinDistance = 1e-6;  ///< metres between centres with a direction of their own
constexpr float kFriction = 0.5f;

/// The distance of the centres of two bodies at which they are not deep in each other, metres.
double deepDistance(const DynamicBody& a, const DynamicBody& b) {
    return kDeepShare * (a.minHalfExtent() + b.minHalfExtent());
}

double distanceOf(const CollisionObject& a, const CollisionObject& b) {
    const glm::dvec3 apart = a.pose.position - b.pose.position;
    return std::sqrt(glm::dot(apart, apart));
}

bool areDeep(const CollisionObject& a, const CollisionObject& b) {
    return a.dynamic && b.dynamic && distanceOf(a, b) < deepDistance(*a.dynamic, *b.dynamic);
}

uint64_t numbersOf(const CollisionObject& a, const CollisionObject& b) {
    return uint64_t(a.number) << 32 | b.number;
}

}  // namespace

void Crowds::thin(std::vector<ObjectPair>& pairs) {
    for (const auto& [a, b] : pairs) a->deepPairs = b->deepPairs = 0;
    bool any = false;
    for (const ObjectPair& pair : pairs)
        if (areDeep(*pair.first, *pair.second))
            any |= ++pair.first->deepPairs > kMaxDeepPairs, any |= ++pair.second->deepPairs > kMaxDeepPairs;
    for (const auto& [a, b] : pairs)
        for (CollisionObject* object : {a, b}) object->isCrowded = object->deepPairs > kMaxDeepPairs;
    if (!any) return;

    // The deep pairs of each crowded body side by side.
    uint32_t slots = 0;
    for (const auto& [a, b] : pairs)
        if (areCrowded(*a, *b)) slots = std::max({slots, a->number + 1, b->number + 1});
    m_from.assign(slots + 1, 0);
    for (const auto& [a, b] : pairs)
        if (areCrowded(*a, *b)) ++m_from[a->number], ++m_from[b->number];
    size_t sum = 0;
    for (size_t& from : m_from) sum += std::exchange(from, sum);
    m_deep.resize(sum);
    std::vector<size_t>& next = m_from;  // moves on to where the next body's begin
    for (size_t i = 0; i < pairs.size(); ++i) {
        const auto& [a, b] = pairs[i];
        if (!areCrowded(*a, *b)) continue;
        const Deep deep{distanceOf(*a, *b), Random(numbersOf(*a, *b)).next(), i};
        m_deep[next[a->number]++] = m_deep[next[b->number]++] = deep;
    }

    m_isDropped.assign(pairs.size(), false);
    for (const Deep& deep : m_deep) m_isDropped[deep.pair] = true;
    for (size_t slot = 0, from = 0; slot < slots; ++slot) {
        const auto begin = m_deep.begin() + ptrdiff_t(from), end = m_deep.begin() + ptrdiff_t(m_from[slot]);
        const auto kept = begin + std::min<ptrdiff_t>(end - begin, kKeptPairs);
        std::partial_sort(begin, kept, end, [](const Deep& a, const Deep& b) {
            return std::tie(a.distance, a.random, a.pair) < std::tie(b.distance, b.random, b.pair);
        });
        for (auto deep = begin; deep != kept; ++deep) m_isDropped[deep->pair] = false;
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
    contact.separation = float(distance - deepDistance(*first.dynamic, *second.dynamic));
    contact.friction = kFriction;
    return contact;
}

}  // namespace rubble
