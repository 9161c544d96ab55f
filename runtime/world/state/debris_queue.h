#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "runtime/core/handle.h"

namespace rubble {

/// How a piece rests: the first give way first.
enum class RestState : uint8_t { Settled, Asleep, Awake };

/// One piece of debris, as its World knows it.
struct Debris {
    BodyHandle body;
    RestState rest = RestState::Awake;
    uint64_t voxels = 0;
    uint64_t createdStep = 0;   ///< step
    uint64_t restingSince = 0;  ///< step at which it fell asleep; not read while it is awake
};

/// All debris of a World in the order in which it gives way. Says nothing that bodies and shapes do not say: it is kept
/// so that a step costs the pieces that changed, not those that are there.
class DebrisQueue {
public:
    /// Adds a piece or takes over what has changed of it.
    void set(const Debris& piece);
    void remove(uint32_t bodySlot);
    void clear() { *this = {}; }

    bool contains(BodyHandle body) const { return body.slot() < m_pieces.size() && m_pieces[body.slot()].body == body; }
    size_t count() const { return m_order.size(); }
    size_t awakeCount() const { return m_awake; }
    uint64_t voxels() const { return m_voxels; }
    /// The piece that gives way next: among all, or among those that move.
    BodyHandle first() const { return m_pieces[m_order.begin()->slot].body; }
    BodyHandle firstAwake() const { return m_pieces[m_order.lower_bound(Key{.rest = RestState::Awake})->slot].body; }
    /// The piece that has slept longest, if it fell asleep in this step or an earlier one.
    std::optional<BodyHandle> asleepSince(uint64_t step) const;

private:
    struct Key {
        RestState rest = RestState::Settled;
        int sizeClass = 0;  ///< bits of its number of voxels
        uint64_t createdStep = 0;
        uint32_t slot = 0;
        friend auto operator<=>(const Key&, const Key&) = default;
    };
    static Key keyOf(const Debris& piece);

    std::vector<Debris> m_pieces;  ///< by slot of the body
    std::set<Key> m_order;
    std::set<std::pair<uint64_t, uint32_t>> m_asleep;  ///< since when, slot
    size_t m_awake = 0;
    uint64_t m_voxels = 0;
};

}  // namespace rubble
