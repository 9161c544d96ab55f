#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace rubble {

/// How far rays may skip over empty sectors of the shadow volume. For each sector of a box and each octant of
/// directions (bit a of its number: down axis a) this is the side of the largest empty cube that has the sector in its
/// corner and lies ahead.
///
/// Derivation. Let s(p) be that side for the octant of +x, +y, +z; 0 if sector p is occupied. A cube of side n + 1 at p
/// is p itself and the seven cubes of side n that begin one sector on along any of the axes, which overlap but leave
/// nothing out. So s(p) = 1 + min over those seven of s, the recurrence of the largest-square problem in three
/// dimensions, and one sweep against the octant's direction solves it. A changed sector can change s only behind it, up
/// to kMaxDistance - 1 sectors away along each axis: an update sweeps that neighbourhood and is exact.
class SkipDistances {
public:
    static constexpr int kMaxDistance = 15;  ///< sectors: larger cubes count as this one, which fits 4 bits

    /// A box of this size with all sectors empty. Sectors outside the box are always empty.
    void reset(glm::ivec3 size);
    /// Gives the box another size and place: what was its sector `low` becomes sector 0. Only the sectors that are new
    /// are computed. Call it after update(); what is no longer in the box must be empty.
    void move(glm::ivec3 low, glm::ivec3 size);
    /// Marks a sector; the distances follow with update(). Until then its own say nothing else.
    void set(glm::ivec3 sector, bool occupied);
    /// Brings the distances up to date. Returns the indices of the sectors that were marked or whose distances changed,
    /// each once.
    const std::vector<size_t>& update();

    /// The index of a sector, x fastest.
    size_t indexOf(glm::ivec3 sector) const {
        return (size_t(sector.z) * size_t(m_size.y) + size_t(sector.y)) * size_t(m_size.x) + size_t(sector.x);
    }
    /// The distances of a sector: 4 bits for each octant, the first one lowest; 0 if the sector is occupied.
    uint32_t at(size_t index) const {
        const auto row = size_t(m_size.x), layer = row * size_t(m_size.y);
        return m_skips[paddedIndexOf({int(index % row), int(index % layer / row), int(index / layer)})];
    }

private:
    struct Box {
        glm::ivec3 low, high;
    };
    std::vector<Box> dirtyBoxes();
    void copyRows(const SkipDistances& from, glm::ivec3 low, const Box& kept);
    Box boxBehind(Box dirty, int octant) const;
    void solve(const Box& box, int octant);
    void markChanged(size_t index);
    size_t paddedIndexOf(glm::ivec3 sector) const {
        return (size_t(sector.z + 1) * size_t(m_size.y + 2) + size_t(sector.y + 1)) * size_t(m_size.x + 2) +
               size_t(sector.x + 1);
    }

    glm::ivec3 m_size{0};
    std::vector<uint32_t> m_skips;      ///< as at(), with a border of one sector
    std::vector<glm::ivec3> m_touched;  ///< sectors changed by set() since the last update()
    std::vector<size_t> m_changed;      ///< by the last update()
    std::vector<bool> m_isChanged;      ///< scratch of update(): which are in m_changed
};

}  // namespace rubble
