#pragma once
#include <glm/vec3.hpp>

#include "runtime/world/objects/lights.h"

namespace rubble::reference {

/// The functions of shaders/lib/sky.glsl on the CPU, without stars; sky_test compares them with what the shaders draw.
/// Directions are unit vectors, y up; results are radiance.
glm::vec3 skyRadiance(const Environment& air, glm::vec3 direction);
/// What mirrors show of it: with clouds and hills.
glm::vec3 mirroredSky(const Environment& air, glm::vec3 direction);
/// What the camera sees behind the level. eyeHeight: metres over the plane of the fields.
glm::vec3 backgroundRadiance(const Environment& air, glm::vec3 direction, glm::vec3 eye, float eyeHeight);
glm::vec3 hazeRadiance(const Environment& air, glm::vec3 direction);
float hazeAmount(const Environment& air, float distanceMetres);

}  // namespace rubble::reference
