#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "runtime/core/handle.h"

namespace rubble {

/// How a piece rests, in the order in which pieces despawn.
enum class RestState : uint8_t { Settled, Asleep, Awake };

/// One piece of debris, as its World knows it.
struct Debris {
    BodyHandle body;
    RestState rest = RestState::Awake;
    uint64_t voxels = 0;
    uint64_t createdStep = 0;
    uint64_t restingSince = 0;  ///< step at which it fell asleep; not read while it is awake
};

/// All debris of a World in the order in which it despawns: a priority queue by rest state, size class, age and slot.
/// It is an index over bodies and shapes: a step costs the pieces that changed, not those that are there.
class DebrisQueue {
public:
    /// Adds a piece or takes over its changes.
    void set(const Debris& piece);
    /// Removes the piece of a body, if it is there.
    void remove(BodyHandle body);
    /// Removes all pieces.
    void clear() { *this = {}; }

    /// Whether a body is debris.
    bool contains(BodyHandle body) const { return body.slot() < m_pieces.size() && m_pieces[body.slot()].body == body; }
    /// Number of pieces.
    size_t count() const { return m_order.size(); }
    /// Number of awake pieces.
    size_t awakeCount() const { return m_awake; }
    /// Voxels of all pieces.
    uint64_t voxels() const { return m_voxels; }
    /// The piece that despawns next; there must be one.
    BodyHandle first() const { return m_pieces[m_order.begin()->slot].body; }
    /// The awake piece that despawns next; there must be one.
    BodyHandle firstAwake() const { return m_pieces[m_order.lower_bound(Key{.rest = RestState::Awake})->slot].body; }
    /// The piece that has slept longest, if it fell asleep in `step` or earlier.
    std::optional<BodyHandle> asleepSince(uint64_t step) const;

private:
    struct Key {
        RestState rest = RestState::Settled;
        int sizeClass = 0;  ///< bits of its voxel count: pieces within a factor of two are equal
        uint64_t createdStep = 0;
        uint32_t slot = 0;
        friend auto operator<=>(const Key&, const Key&) = default;
    };
    static Key keyOf(const Debris& piece);

    std::vector<Debris> m_pieces;  ///< by slot of the body
    std::set<Key> m_order;
    std::set<std::pair<uint64_t, uint32_t>> m_asleep;  ///< step at which it fell asleep, slot
    size_t m_awake = 0;
    uint64_t m_voxels = 0;
};

}  // namespace rubble
