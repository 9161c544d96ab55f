#pragma once
#include <glm/vec3.hpp>

#include "runtime/world/objects/lights.h"

namespace rubble::reference {

/// The clear sky without sun disc. This and the functions below are those of shaders/lib/sky.glsl, without stars;
/// sky_test compares them with the shaders. Directions are unit vectors, y up; results are linear radiance.
glm::vec3 skyRadiance(const Environment& air, glm::vec3 direction);
/// What mirrors show behind the level: sky with clouds and hills, and fields. eye: world position; eyeHeight: metres
/// above the plane of the fields.
glm::vec3 mirroredBackground(const Environment& air, glm::vec3 direction, glm::vec3 eye, float eyeHeight);
/// What the camera sees there.
glm::vec3 backgroundRadiance(const Environment& air, glm::vec3 direction, glm::vec3 eye, float eyeHeight);
/// Light that the haze scatters into a ray toward a far point.
glm::vec3 hazeRadiance(const Environment& air, glm::vec3 direction);
/// Share of light that the haze takes over a distance, 0 to 1.
float hazeAmount(const Environment& air, float distanceMetres);

}  // namespace rubble::reference
