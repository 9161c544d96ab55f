#pragma once
#include "runtime/world/objects/lights.h"

namespace rubble {

/// Sets the colours of sun, sky, haze and ground light, and the stars, from where the sun stands: redder the more air
/// its light has come through, twilight after it has set, and below that a night whose light is the moon's. `clouds` of
/// the environment (over 0.5) takes the sun away and greys the sky. Other fields stay. sunDirection: world, y up, any
/// length; below the horizon too. The same on every machine.
void applySkyModel(Environment& environment, glm::vec3 sunDirection);

}  // namespace rubble
