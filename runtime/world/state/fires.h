#pragma once
#include <vector>

#include "runtime/world/state/world_state.h"

namespace rubble {

/// A burning brick in the world.
struct Fire {
    ShapeHandle shape;
    glm::ivec3 brick;
    glm::dvec3 position;  ///< the centroid of its voxels, metres
    double radius;        ///< metres
    float intensity;      ///< 0 to 1: rises when lit, falls with the fuel
    uint32_t seed;        ///< the same for a fire from its first step to its last
};

/// What burns, in slot order. Costs what is hot. Events are in FrameChanges.
std::vector<Fire> findFires(const WorldState& world);

/// A light that flickers over fires near each other.
struct FireLight {
    glm::dvec3 position;
    float intensity;  ///< of the fires that it stands for, in sum, flickering
    double radius;    ///< metres
};

/// Lights for the most intense groups of fires, at most `limit`, the brightest first. Fires in the same cell of a grid
/// share a light, at the mean of their positions weighted by intensity. The flicker depends on the step alone.
std::vector<FireLight> fireLights(const std::vector<Fire>& fires, uint64_t step, size_t limit);

/// Share of its strength, 0 to 1, that char and heat have left to a brick of a live shape.
double remainingStrength(const WorldState& world, ShapeHandle shape, glm::ivec3 brick);

}  // namespace rubble
