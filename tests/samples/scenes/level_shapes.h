#pragma once
#include "runtime/world/level/level.h"

namespace rubble {

/// Calls f(body, shape) for all shapes of a level.
template <class F>
void forEachShape(const Level& level, F&& f) {
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes) f(body, shape);
}

}  // namespace rubble
