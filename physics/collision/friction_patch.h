#pragma once
#include <span>

#include "physics/collision/manifold.h"

namespace rubble {

/// The mean distance of the area in which two objects touch from its middle, metres; 0 if it has no area. contacts: all
/// that there are with normals of one direction, the deepest first. See friction_patch.cpp for the method.
float meanPatchRadius(std::span<const ContactPoint> contacts, const Manifold& manifold);
/// Sorts points by their angle about a middle, counterclockwise as seen against the normal, from the first one on.
void sortAround(std::span<glm::vec3> points, const glm::vec3& middle, const glm::vec3& normal);
/// Moves the places at which the points of one direction have friction towards the centre of their pressure, until
/// their mean distance from it is that of the area: so they resist spin as the area would.
void insetFriction(std::span<ManifoldPoint> points, float meanRadius);

}  // namespace rubble
