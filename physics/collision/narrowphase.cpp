#include "physics/collision/narrowphase.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <thread>
#include <tuple>
#include <utility>

#include "physics/bodies/dynamic_body.h"
#include "physics/collision/crowd.h"
#include "physics/collision/impact_contacts.h"
#include "physics/collision/round_contacts.h"
#include "runtime/core/planted_fault.h"
#include "runtime/core/prefetch.h"

namespace rubble {
namespace {

constexpr size_t kPairsPerBatch = 32;
constexpr float kUnlimited = 1e9f;  ///< metres
/// Relative motion of two bodies, as a fraction of the contact margin, up to which their cached contacts are used, and
/// of their voxels where these are small: a ball that rolls on as if it stood on its last contact falls off it.
constexpr double kMaxCachedMotion = 0.05, kMaxCachedVoxels = 0.02;
constexpr double kMaxStraightError = 1.0;  ///< voxels by which a point may leave the line along which it is searched

/// Begins to load what is asked of the second objects of pairs to come, which lie anywhere in memory: first the object,
/// then, some pairs later, what it points to.
void prefetchSeconds(std::span<const ObjectPair> pairs) {
    if (pairs.size() > 6) prefetch(pairs[6].second, sizeof(CollisionObject));
    if (pairs.size() > 4) {
        const CollisionObject& object = *pairs[4].second;
        prefetch(object.collider.parts.data(), sizeof object.collider.parts[0]);
        prefetch(object.cellTransforms().data(), sizeof(CellTransform));
    }
    if (pairs.size() > 2 && !pairs[2].second->collider.parts.empty())
        prefetch(pairs[2].second->collider.parts[0].get(), sizeof(ColliderPart));
}

template <class T>
bool isBefore(const T& a, const T& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
}
bool isPointedBefore(const Manifold* a, const Manifold* b) {
    return isBefore(*a, *b);
}

/// The share of the step in which an object of this motion and radius turns along an almost straight path. Contacts are
/// searched along straight lines, so that beyond it they are of no use: continuous_collision.h does the rest.
double straightShare(const Motion& motion, double voxel, double seconds) {
    const double angle2 = glm::dot(motion.angularVelocity, motion.angularVelocity) * seconds * seconds,
                 straight2 = 2.0 * kMaxStraightError * voxel / std::max(motion.radius, voxel);
    return angle2 > straight2 ? std::sqrt(straight2 / angle2) : 1.0;
}

/// The motion of an object in this step; a sleeping body does not move.
Motion motionOf(const CollisionObject& object) {
    Motion motion{.pose = object.pose, .cellTransforms = object.cellTransforms(), .radius = object.radius};
    if (!object.dynamic || object.dynamic->asleep()) return motion;
    motion.velocity = object.dynamic->motion.velocity;
    motion.angularVelocity = object.dynamic->motion.angularVelocity;
    return motion;
}

/// The pairs of the same first object with static ones, if this is one of them.
StaticNeighbours neighboursOf(std::span<const ObjectPair> pairs, size_t number) {
    const CollisionObject* first = pairs[number].first;
    if (pairs[number].second->dynamic) return {};
    const auto isBeside = [&](size_t i) { return pairs[i].first == first && !pairs[i].second->dynamic; };
    size_t from = number, to = number + 1;
    while (from > 0 && isBeside(from - 1)) --from;
    while (to < pairs.size() && isBeside(to)) ++to;
    return {pairs.subspan(from, to - from), number - from};
}

bool isTouchedAsRound(const Manifold& manifold) {
    const auto points = manifold.all();
    return std::any_of(points.begin(), points.end(),
                       [](const ManifoldPoint& p) { return p.feature & (kFirstIsRound | kSecondIsRound); });
}

}  // namespace

void Narrowphase::begin() {
    m_now ^= 1;
    Set& set = m_sets[m_now];
    set.list.clear();
    set.usedBatches = set.usedPairs = 0;
}

void Narrowphase::forget() {
    begin();
    m_resting.clear();
}

/// The contacts of a pair, from the voxels of its objects.
void Narrowphase::findPairContacts(std::span<const ObjectPair> pairs, size_t number,
                                   const NarrowphaseSettings& settings, double displacement, Batch& batch, Pair& pair) {
    const auto [first, second] = pairs[number];
    const Motion firstMotion = motionOf(*first), secondMotion = motionOf(*second);
    const StaticNeighbours neighbours = neighboursOf(pairs, number);
    const double voxel = std::min(first->smallestVoxel, second->smallestVoxel);
    NarrowphaseSettings straight = settings;
    straight.seconds *= std::min(straightShare(firstMotion, voxel, settings.seconds),
                                 straightShare(secondMotion, voxel, settings.seconds));
    const bool isNear = findContacts(first->collider, firstMotion, second->collider, secondMotion, straight,
                                     pair.search, batch.contacts, neighbours);
    batch.bricksLeftOut += pair.search.leftOut;
    pair.isCacheable = displacement <= settings.margin;
    if (isNear && batch.contacts.empty() && displacement > settings.sweepThreshold && displacement > voxel &&
        mayPass(*first, *second, displacement))
        findImpactContacts(*first, *second, straight, pair.search.axis, batch.contacts, neighbours);
}

/// before: the pair in the step before; null: it is new. pair: what is remembered of it.
void Narrowphase::collidePair(std::span<const ObjectPair> pairs, size_t number, const NarrowphaseSettings& settings,
                              const Pair* before, Batch& batch, Pair& pair) const {
    const auto [first, second] = pairs[number];
    const bool isKnown = before && before->firstVersion == first->version && before->secondVersion == second->version;
    const double displacement = maxRelativeDisplacement(*first, *second);
    const bool isSlow = displacement <= settings.margin;
    const RelativePose pose = relativePose(first->pose, second->pose);
    const auto makeManifold = [&]() -> Manifold& {
        Manifold& manifold = batch.manifolds[batch.used++];
        manifold = {};
        manifold.points = batch.points.data() + batch.usedPoints;
        pair.manifold = &manifold;
        return manifold;
    };
    if (isKnown) {
        const double moved = maxPointDisplacement(before->pose, pose, first->radius);
        const double voxel = std::min(first->smallestVoxel, second->smallestVoxel),
                     kept = std::min(kMaxCachedMotion * settings.margin, kMaxCachedVoxels * voxel);
        const bool isKept = isSlow && before->isCacheable && moved < kept;
        if (isKept || (moved + displacement < double(before->search.clearance) && !areCrowded(*first, *second))) {
            pair = *before;
            if (!before->manifold) return;
            Manifold& manifold = makeManifold();
            manifold.copyFrom(*before->manifold);
            batch.usedPoints += size_t(manifold.count);
            return updateCachedContacts(manifold, before->pose, pose, first->pose, second->pose);
        }
    }
    pair = {first->number, second->number, first->version, second->version};
    if (before) pair.search = before->search;
    batch.contacts.clear();
    if (areCrowded(*first, *second))
        batch.contacts.push_back(crowdContact(*first, *second));
    else
        findPairContacts(pairs, number, settings, displacement, batch, pair);
    pair.pose = pose;
    if (batch.contacts.empty()) return;
    Manifold& manifold = makeManifold();
    manifold.first = first->number;
    manifold.second = second->number;
    manifold.origin = first->pose.position;
    manifold.objects = pairs[number];
    const Manifold* known = before                                          ? before->manifold
                            : m_resting.find(*first, *second, batch.rested) ? &batch.rested
                                                                            : nullptr;
    reduceContacts(batch.contacts, first->isNew || second->isNew ? nullptr : known,
                   2.0 * displacement <= settings.margin ? kRestingLimits : kHitLimits, manifold);
    batch.usedPoints += size_t(manifold.count);
    manifold.isRound = isTouchedAsRound(manifold);
    cacheContacts(manifold, first->pose, second->pose);
    manifold.allowedPenetration = 0.0f;
    if (!second->dynamic)
        updateAllowedPenetration(manifold, known ? known->allowedPenetration : before ? 0.0f : kUnlimited);
}

/// Merges the sorted pairs with those of the step before. from: the first of them in the batch, whose pairs are `out`.
void Narrowphase::collideBatch(std::span<const ObjectPair> pairs, size_t from, const NarrowphaseSettings& settings,
                               Batch& batch, std::span<Pair> out) const {
    const std::span<const Pair> known = m_sets[m_now ^ 1].all();
    batch.used = batch.usedPoints = batch.bricksLeftOut = 0;
    if (batch.manifolds.size() < out.size()) {
        batch.manifolds.resize(out.size());
        batch.points.resize(out.size() * size_t(kMaxManifoldPoints));
    }
    auto next = known.end();
    for (size_t i = 0; i < out.size(); ++i) {
        prefetchSeconds(pairs.subspan(from + i, out.size() - i));
        Pair& pair = out[i];
        pair.first = pairs[from + i].first->number, pair.second = pairs[from + i].second->number;
        if (i == 0) next = std::lower_bound(known.begin(), known.end(), pair, isBefore<Pair>);
        while (next != known.end() && isBefore(*next, pair)) ++next;
        const bool isKnown = next != known.end() && !isBefore(pair, *next);
        collidePair(pairs, from + i, settings, isKnown ? &*next : nullptr, batch, pair);
    }
}

size_t Narrowphase::bricksLeftOut() const {
    const Set& set = m_sets[m_now];
    size_t sum = 0;
    for (size_t i = 0; i < set.usedBatches; ++i) sum += set.batches[i]->bricksLeftOut;
    return sum;
}

void Narrowphase::collide(std::span<const ObjectPair> pairs, const NarrowphaseSettings& settings,
                          const ParallelFor& parallelFor) {
    Set& set = m_sets[m_now];
    const size_t batches = (pairs.size() + kPairsPerBatch - 1) / kPairsPerBatch, firstBatch = set.usedBatches;
    set.usedBatches += batches;
    while (set.batches.size() < set.usedBatches) set.batches.push_back(std::make_unique<Batch>());
    const size_t firstPair = std::exchange(set.usedPairs, set.usedPairs + pairs.size());
    if (set.pairs.size() < set.usedPairs) set.pairs.resize(set.usedPairs + set.usedPairs / 4);
    [[maybe_unused]] const std::thread::id caller = std::this_thread::get_id();
    const auto collideOne = [&](size_t i) {
        const size_t from = i * kPairsPerBatch, count = std::min(kPairsPerBatch, pairs.size() - from);
        collideBatch(pairs, from, settings, *set.batches[firstBatch + i],
                     std::span(set.pairs).subspan(firstPair + from, count));
        // As if two threads had written to one list: the contacts of one of them are lost.
        if (isPlanted("race") && std::this_thread::get_id() != caller) set.batches[firstBatch + i]->used = 0;
    };
    parallelFor(batches, std::ref(collideOne));
    const CollisionObject* first = nullptr;
    for (const ObjectPair& pair : pairs) {
        if (pair.first == first) continue;
        first = pair.first;
        if (first->dynamic && !first->dynamic->asleep()) m_resting.forget(*first);
    }
    for (size_t i = firstBatch; i < set.usedBatches; ++i)
        for (size_t m = 0; m < set.batches[i]->used; ++m) set.list.push_back(&set.batches[i]->manifolds[m]);
    if (!firstBatch) return;
    std::sort(set.list.begin(), set.list.end(), isPointedBefore);
    std::sort(set.pairs.begin(), set.pairs.begin() + std::ptrdiff_t(set.usedPairs), isBefore<Pair>);
}

}  // namespace rubble
