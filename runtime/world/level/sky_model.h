#pragma once
#include "runtime/world/objects/lights.h"

namespace rubble {

/// Sets direction and colour of the sun, colours of sky, haze and ground, and the stars from the direction to the sun:
/// redder the more air its light crosses, twilight after it has set, and then a night lit by the moon. Cloud cover over
/// 0.5 hides the sun and greys the sky. Other fields stay. sunDirection: world, y up, any length, also below the
/// horizon. Only additions and multiplications: the same on every machine.
void applySkyModel(Environment& environment, glm::vec3 sunDirection);

}  // namespace rubble
