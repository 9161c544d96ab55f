#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/solver/contact_set.h"

namespace rubble {

/// Packs pairs of bodies into groups that share no body, so that the pairs of a group can be solved at once. Pairs of
/// one kind and one number of points come together, as far as there are enough of them.
class LanePacking {
public:
    /// Forgets the groups, and begins with the contacts of a set.
    void begin(ContactSet& set);
    /// Appends groups of these pairs; each pair learns its group and lane. Pairs without points are left out.
    void pack(ContactSet& set, std::span<const uint32_t> pairs);

private:
    static constexpr uint32_t kSlots = 64;  ///< groups that are open at a time
    struct Slot {
        uint32_t key = 0, count = 0;
        uint32_t pairs[kLanes];
    };
    void add(ContactSet& set, uint32_t pair, uint32_t key);
    uint32_t takeSlot(ContactSet& set, uint32_t key);
    void close(ContactSet& set, uint32_t slot);
    void emit(ContactSet& set, const Slot& slot);

    Slot m_slots[kSlots];
    uint64_t m_inUse = 0;                 ///< slots
    std::vector<uint64_t> m_openByKey;    ///< slots of each key
    std::vector<uint64_t> m_slotsOfBody;  ///< that have it, by body
    uint32_t m_oldest = 0;                ///< the slot to be closed next when none is free
    std::vector<uint32_t> m_rest;
};

}  // namespace rubble
