#include "physics/narrowphase.h"

#include <algorithm>
#include <tuple>

#include "physics/dynamic_body.h"

namespace rubble {
namespace {

constexpr size_t kBatch = 32;  ///< pairs

bool isBefore(const Manifold* a, const Manifold* b) {
    return std::tie(a->first, a->second) < std::tie(b->first, b->second);
}

Motion motionOf(const CollisionObject& object) {
    Motion motion{.pose = object.pose, .lattices = object.lattices(), .radius = object.radius};
    if (!object.dynamic || object.dynamic->asleep()) return motion;
    motion.velocity = object.dynamic->motion.velocity;
    motion.angularVelocity = object.dynamic->motion.angularVelocity;
    return motion;
}

}  // namespace

void Narrowphase::begin() {
    m_now ^= 1;
    Set& set = m_sets[m_now];
    set.list.clear();
    set.usedBatches = 0;
}

const Manifold* Narrowphase::before(uint32_t first, uint32_t second) const {
    const std::vector<Manifold*>& old = m_sets[m_now ^ 1].list;
    Manifold key;
    key.first = first, key.second = second;
    const auto at = std::lower_bound(old.begin(), old.end(), &key, isBefore);
    return at != old.end() && (*at)->first == first && (*at)->second == second ? *at : nullptr;
}

void Narrowphase::collideBatch(std::span<const ObjectPair> pairs, const NarrowphaseSettings& settings, Batch& batch) const {
    batch.used = 0;
    if (batch.manifolds.size() < pairs.size()) batch.manifolds.resize(pairs.size());
    for (const auto& [first, second] : pairs) {
        batch.contacts.clear();
        findContacts(first->collider, motionOf(*first), second->collider, motionOf(*second), settings, batch.contacts);
        if (batch.contacts.empty()) continue;
        Manifold& manifold = batch.manifolds[batch.used++];
        manifold.first = first->number;
        manifold.second = second->number;
        manifold.origin = first->pose.position;
        manifold.objects = {first, second};
        reduceContacts(batch.contacts, before(first->number, second->number), manifold);
    }
}

void Narrowphase::collide(std::span<const ObjectPair> pairs, const NarrowphaseSettings& settings, const ParallelFor& parallelFor) {
    Set& set = m_sets[m_now];
    const size_t batches = (pairs.size() + kBatch - 1) / kBatch, firstBatch = set.usedBatches;
    set.usedBatches += batches;
    while (set.batches.size() < set.usedBatches) set.batches.push_back(std::make_unique<Batch>());
    parallelFor(batches, [&](size_t i) {
        collideBatch(pairs.subspan(i * kBatch, std::min(kBatch, pairs.size() - i * kBatch)), settings, *set.batches[firstBatch + i]);
    });
    for (size_t i = firstBatch; i < set.usedBatches; ++i)
        for (size_t m = 0; m < set.batches[i]->used; ++m) set.list.push_back(&set.batches[i]->manifolds[m]);
    if (firstBatch) std::sort(set.list.begin(), set.list.end(), isBefore);
}

}  // namespace rubble
