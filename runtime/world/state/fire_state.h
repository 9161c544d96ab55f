#pragma once
#include <optional>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/destruction/heat.h"

namespace rubble {

/// What is hot, burning or wet of one shape.
struct HeatField {
    ShapeHandle shape;
    std::vector<HotBrick> bricks;  ///< by cellBefore()
};

/// All heat of a world: sparse, plain data, empty where nothing has been heated. May be copied, saved and put back.
struct FireState {
    std::vector<HeatField> fields;  ///< by slot of the shape; none is empty
    uint32_t hotBricks = 0;         ///< bricks in all fields
    uint32_t burning = 0;           ///< of them
    bool hasLoggedFull = false;     ///< a limit has been logged once

    bool isActive() const { return !fields.empty(); }
    const HotBrick* find(ShapeHandle shape, glm::ivec3 brick) const;
    HotBrick* find(ShapeHandle shape, glm::ivec3 brick);
    /// The brick's state, a new one if it has none; nullptr if there is none and `limit` bricks are hot already.
    HotBrick* findOrAdd(ShapeHandle shape, glm::ivec3 brick, uint32_t limit);
    /// Drops empty fields and counts anew.
    void compact();
    uint64_t hash() const;
};

/// A burning brick in the world.
struct Fire {
    ShapeHandle shape;
    glm::ivec3 brick;
    glm::dvec3 position;  ///< the middle of its voxels, metres
    double radius;        ///< metres
    float intensity;      ///< 0 to 1: rises when lit, falls with the fuel
    uint32_t seed;        ///< the same for a fire from its first step to its last
};

/// A light that flickers over fires near each other.
struct FireLight {
    glm::dvec3 position;
    float intensity;  ///< of the fires that it stands for, in sum, flickering
    double radius;    ///< metres
};
/// Lights for the biggest groups of fires, at most `limit`, biggest first.
std::vector<FireLight> fireLights(const std::vector<Fire>& fires, uint64_t step, size_t limit);

}  // namespace rubble
