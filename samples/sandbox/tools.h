#pragma once
#include <array>

#include "runtime/world/world.h"

namespace rubble {

enum class HandTool { Hammer, Explosive, SprayCan };

/// What using a tool along a ray does to the world, as edits for the next step. Nothing if it hits nothing within
/// reach.
Edits useTool(HandTool tool, const World& world, glm::dvec3 originWorld, glm::dvec3 directionWorld, uint32_t seed);

}  // namespace rubble
