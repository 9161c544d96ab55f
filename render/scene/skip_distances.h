#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace rubble {

/// For each brick of a box and each octant of directions (bit a of its number set: down axis a) the side of the largest
/// empty cube that has this brick in its corner and lies ahead. Exact after every update, which costs what changed and
/// its neighbourhood.
class SkipDistances {
public:
    static constexpr int kMaxDistance = 15;  ///< bricks: no cube is larger

    /// All empty. What lies outside the box always is.
    void reset(glm::ivec3 size);
    void set(glm::ivec3 brick, bool occupied);
    /// Works out what the calls of set() since the last one changed: the indices of the bricks whose cubes are others
    /// now.
    const std::vector<size_t>& update();

    size_t indexOf(glm::ivec3 brick) const {
        return (size_t(brick.z) * size_t(m_size.y) + size_t(brick.y)) * size_t(m_size.x) + size_t(brick.x);
    }
    /// Four bits for each octant from the lowest on; 0 if the brick is occupied.
    uint32_t at(size_t index) const { return m_skips[index]; }

private:
    struct Box {
        glm::ivec3 low, high;
    };
    std::vector<Box> dirtyBoxes();
    void sweep(const Box& dirty, int octant);
    size_t paddedIndexOf(glm::ivec3 brick) const {
        return (size_t(brick.z + 1) * size_t(m_size.y + 2) + size_t(brick.y + 1)) * size_t(m_size.x + 2) +
               size_t(brick.x + 1);
    }

    glm::ivec3 m_size{0};
    std::vector<uint8_t> m_occupied;              ///< with a border of one brick, as m_sides
    std::array<std::vector<uint8_t>, 8> m_sides;  ///< by octant
    std::vector<uint32_t> m_skips;                ///< the same, packed
    std::vector<glm::ivec3> m_touched;            ///< by set()
    std::vector<size_t> m_changed;
};

}  // namespace rubble
