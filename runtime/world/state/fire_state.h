#pragma once
#include <cstdint>
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

    /// Whether anything is hot, burning or wet.
    bool isActive() const { return !fields.empty(); }
    /// The state of a brick; null if it is neither hot nor wet.
    const HotBrick* find(ShapeHandle shape, glm::ivec3 brick) const;
    /// The state of a brick, to be changed; null if it is neither hot nor wet.
    HotBrick* find(ShapeHandle shape, glm::ivec3 brick);
    /// The brick's state, a new one if it has none; nullptr if there is none and `limit` bricks are hot already.
    HotBrick* findOrAdd(ShapeHandle shape, glm::ivec3 brick, uint32_t limit);
    /// Removes the bricks of a shape and returns them; the counts are as compact() makes them.
    std::vector<HotBrick> take(ShapeHandle shape);
    /// Drops empty fields and counts again. To be called after `fields` was changed from outside.
    void compact();
    /// A hash of all fields, in slot order.
    uint64_t hash() const;
};

}  // namespace rubble
