#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "render/scene/layer_counts.h"

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
    glm::ivec3 low() const { return {m_axes[0].low(), m_axes[1].low(), m_axes[2].low()}; }
    /// Its high corner, excluded.
    glm::ivec3 high() const { return {m_axes[0].high(), m_axes[1].high(), m_axes[2].high()}; }

private:
    std::array<LayerCounts, 3> m_axes;
};

}  // namespace rubble
