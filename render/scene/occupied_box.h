#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace rubble {

/// The box around all occupied words of the shadow volume. It grows and shrinks with them: for each axis it counts the
/// bricks that hold anything in a layer of words.
class OccupiedBox {
public:
    /// Forgets all bricks.
    void clear() { m_axes = {}; }
    /// A brick's occupied words (ShadowBrick::occupied) become others; 0: none.
    void change(glm::ivec3 brick, uint64_t before, uint64_t after);
    /// Its low corner, in words of the world; (0, 0, 0) if nothing is occupied.
    glm::ivec3 low() const { return {m_axes[0].low, m_axes[1].low, m_axes[2].low}; }
    /// Its high corner, excluded.
    glm::ivec3 high() const { return {m_axes[0].high, m_axes[1].high, m_axes[2].high}; }

private:
    struct Axis {
        std::vector<uint32_t> counts;  ///< by layer
        int first = 0;                 ///< the layer of counts[0]
        int low = 0, high = 0;         ///< layers; high excluded
        /// The count of a layer; layers up to it are counted from now on.
        uint32_t& at(int layer);
        /// One brick more in a layer.
        void add(int layer);
        /// One brick less.
        void remove(int layer);
    };
    std::array<Axis, 3> m_axes;
};

}  // namespace rubble
