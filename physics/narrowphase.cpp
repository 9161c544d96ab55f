#include "physics/narrowphase.h"

#include <algorithm>
#include <tuple>

#include "physics/dynamic_body.h"

namespace rubble {
namespace {

constexpr size_t kBatch = 32;  ///< pairs

template <class T>
bool isBefore(const T& a, const T& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
}
bool isListedBefore(const Manifold* a, const Manifold* b) {
    return isBefore(*a, *b);
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
    set.axes.clear();
    set.usedBatches = 0;
}

const Manifold* Narrowphase::before(uint32_t first, uint32_t second) const {
    const std::vector<Manifold*>& old = m_sets[m_now ^ 1].list;
    Manifold key;
    key.first = first, key.second = second;
    const auto at = std::lower_bound(old.begin(), old.end(), &key, isListedBefore);
    return at != old.end() && (*at)->first == first && (*at)->second == second ? *at : nullptr;
}

void Narrowphase::collideBatch(std::span<const ObjectPair> pairs, const NarrowphaseSettings& settings, Batch& batch, std::span<Axis> axes) const {
    const std::vector<Axis>& known = m_sets[m_now ^ 1].axes;
    auto next = known.end();
    batch.used = 0;
    if (batch.manifolds.size() < pairs.size()) batch.manifolds.resize(pairs.size());
    for (size_t i = 0; i < pairs.size(); ++i) {
        const auto [first, second] = pairs[i];
        axes[i] = {first->number, second->number, glm::vec3(0.0f)};
        if (i == 0) next = std::lower_bound(known.begin(), known.end(), axes[i], isBefore<Axis>);
        while (next != known.end() && isBefore(*next, axes[i])) ++next;
        if (next != known.end() && !isBefore(axes[i], *next)) axes[i].direction = next->direction;
        batch.contacts.clear();
        findContacts(first->collider, motionOf(*first), second->collider, motionOf(*second), settings, axes[i].direction, batch.contacts);
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
    const size_t firstAxis = set.axes.size();
    set.axes.resize(firstAxis + pairs.size());
    parallelFor(batches, [&](size_t i) {
        const size_t from = i * kBatch, count = std::min(kBatch, pairs.size() - from);
        collideBatch(pairs.subspan(from, count), settings, *set.batches[firstBatch + i], std::span(set.axes).subspan(firstAxis + from, count));
    });
    for (size_t i = firstBatch; i < set.usedBatches; ++i)
        for (size_t m = 0; m < set.batches[i]->used; ++m) set.list.push_back(&set.batches[i]->manifolds[m]);
    if (!firstBatch) return;
    std::sort(set.list.begin(), set.list.end(), isListedBefore);
    std::sort(set.axes.begin(), set.axes.end(), isBefore<Axis>);
}

}  // namespace rubble
