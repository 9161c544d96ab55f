#pragma once
#include <rubble/rubble.h>

#include <string>

namespace lua_sample {

/// Builds a small yard in an empty world, whose things have tags: a static "wall" of brick, x -2 to 2, y 0 to 2.5, z 0
/// to 0.3 m; a wooden "crate" of 0.8 m before it, at z -2 to -1.2; a "door" that turns on a "hinge" at x 4; a "weight"
/// that hangs from a "gallows" by a "rope" at x -5; a light "bulb" over the crate; a trigger "gate" around it. Returns
/// what is wrong, or "".
std::string buildYard(const rubble_api& api, rubble_world world);

}  // namespace lua_sample
