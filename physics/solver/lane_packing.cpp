#include "physics/solver/lane_packing.h"

#include <algorithm>
#include <bit>

namespace rubble {
namespace {

constexpr uint32_t kCounts = kMaxManifoldPoints + 1, kKinds = 16;

uint32_t kindOf(const PairConstraints& pair) {
    return uint32_t(pair.isHit) | uint32_t(pair.isFollowed) << 1 | uint32_t(pair.manifold->isRound) << 2 |
           uint32_t(pair.isStiff) << 3;
}

}  // namespace

void LanePacking::begin(ContactSet& set) {
    set.groups.clear();
    set.contactCount = 0;
    m_slotsOfBody.assign(set.states.size(), 0);
    m_openByKey.assign(size_t(kKinds) * kCounts, 0);
}

void LanePacking::pack(ContactSet& set, std::span<const uint32_t> pairs) {
    for (const uint32_t pair : pairs)
        if (const int count = set.pairs[pair].manifold->count)
            add(set, pair, kindOf(set.pairs[pair]) * kCounts + uint32_t(count));
    // The rest of each kind together, whatever their numbers of points.
    m_rest.clear();
    for (uint32_t i = 0; i < kSlots; ++i)
        if (m_inUse >> i & 1) m_rest.insert(m_rest.end(), m_slots[i].pairs, m_slots[i].pairs + m_slots[i].count);
    for (const uint32_t pair : m_rest)
        m_slotsOfBody[size_t(set.pairs[pair].a)] = m_slotsOfBody[size_t(set.pairs[pair].b)] = 0;
    std::fill(m_openByKey.begin(), m_openByKey.end(), 0);
    m_inUse = 0;
    for (const uint32_t pair : m_rest) add(set, pair, kindOf(set.pairs[pair]) * kCounts);
    for (uint32_t i = 0; i < kSlots; ++i)
        if (m_inUse >> i & 1) close(set, i);
}

void LanePacking::add(ContactSet& set, uint32_t pair, uint32_t key) {
    const auto bodies = {size_t(set.pairs[pair].a), size_t(set.pairs[pair].b)};
    uint64_t taken = 0;
    for (const size_t body : bodies) taken |= m_slotsOfBody[body];
    const uint64_t open = m_openByKey[key] & ~taken;
    const uint32_t slot = open ? uint32_t(std::countr_zero(open)) : takeSlot(set, key);
    m_slots[slot].pairs[m_slots[slot].count++] = pair;
    for (const size_t body : bodies)
        if (body) m_slotsOfBody[body] |= uint64_t(1) << slot;
    if (m_slots[slot].count == kLanes) close(set, slot);
}

uint32_t LanePacking::takeSlot(ContactSet& set, uint32_t key) {
    uint32_t slot = uint32_t(std::countr_one(m_inUse));
    if (slot == kSlots) {
        slot = m_oldest++ % kSlots;
        close(set, slot);
    }
    m_inUse |= uint64_t(1) << slot;
    m_openByKey[key] |= uint64_t(1) << slot;
    m_slots[slot].key = key;
    m_slots[slot].count = 0;
    return slot;
}

void LanePacking::close(ContactSet& set, uint32_t slot) {
    const uint64_t keep = ~(uint64_t(1) << slot);
    const Slot& closed = m_slots[slot];
    emit(set, closed);
    for (uint32_t i = 0; i < closed.count; ++i)
        for (const int body : {set.pairs[closed.pairs[i]].a, set.pairs[closed.pairs[i]].b})
            m_slotsOfBody[size_t(body)] &= keep;
    m_inUse &= keep;
    m_openByKey[closed.key] &= keep;
}

void LanePacking::emit(ContactSet& set, const Slot& slot) {
    PairGroup& group = set.groups.emplace_back();
    group.from = set.contactCount;
    std::fill(group.pair, group.pair + kLanes, PairGroup::kNone);
    for (uint32_t lane = 0; lane < slot.count; ++lane) {
        PairConstraints& pair = set.pairs[slot.pairs[lane]];
        pair.group = uint32_t(set.groups.size() - 1), pair.lane = lane;
        group.a[lane] = pair.a, group.b[lane] = pair.b, group.pair[lane] = slot.pairs[lane];
        group.count = std::max(group.count, uint32_t(pair.manifold->count));
        group.anyHit |= pair.isHit, group.anyFollowed |= pair.isFollowed, group.anyRound |= pair.manifold->isRound;
    }
    set.contactCount += group.count;
}

}  // namespace rubble
