#pragma once
#include <string>
#include <string_view>

#include "runtime/voxel/material.h"
#include "runtime/world/objects/body.h"
#include "runtime/world/objects/character.h"
#include "runtime/world/objects/joint.h"
#include "runtime/world/objects/lights.h"
#include "runtime/world/objects/note.h"
#include "runtime/world/objects/shape.h"
#include "runtime/world/objects/trigger.h"
#include "runtime/world/objects/water.h"

namespace rubble {

// What is wrong with the numbers of an object, by runtime/core/ranges.h; empty: nothing. Levels, saves, recordings,
// edits and the C interface ask the same functions. Handles and names are not checked.

/// About a material of a level.
std::string objectError(const Material& material);
/// About an entry of a palette, its material and light group apart.
std::string objectError(const PaletteEntry& entry);
/// About the place and motion of a body.
std::string objectError(const Body& body);
/// About the place, voxel size and strength of a shape.
std::string objectError(const Shape& shape);
/// The same of the shape's own numbers, for shapes that are no Shape.
std::string shapeError(const Pose& local, float voxelSize, float strength);
/// About the factors of a shape's density and emission.
std::string factorsError(float density, float emission);
/// See lightError().
std::string objectError(const Light& light);
/// About a light group.
std::string objectError(const LightGroup& group);
/// About a body of water.
std::string objectError(const Water& water);
/// About a trigger.
std::string objectError(const Trigger& trigger);
/// About a box. Its corners are equal, which stands for no box, or the low one is below the other along each axis.
std::string objectError(const WorldBox& box);
/// About a character.
std::string objectError(const Character& character);
/// See jointError().
std::string objectError(const Joint& joint);
/// About the texts of a note.
std::string objectError(const Note& note);
/// About a name, or the value of a tag: `what` it is.
std::string nameError(const char* what, std::string_view text);
/// About the name of a tag, which is not empty and has no "=".
std::string tagError(std::string_view tag);
/// About the velocity that a character has or wishes; `name`: of it.
std::string characterVelocityError(const char* name, const glm::dvec3& velocity);

}  // namespace rubble
