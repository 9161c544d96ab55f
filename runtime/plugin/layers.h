#pragma once
#include <memory>

#include "physics/physics_world.h"
#include "runtime/world/settings/world_settings.h"

// Which modules above the runtime a library has. Each library links one of two files of layers/ for each: physics.cpp
// or no_physics.cpp, renderer.cpp or no_renderer.cpp.
namespace rubble {

/// Physics of Rubble's own; null in a library without.
std::unique_ptr<PhysicsWorld> makePhysics(const PhysicsSettings& settings);
/// The settings of a preset; `given` for PhysicsPreset::Given, and in a library without physics.
PhysicsSettings physicsPreset(PhysicsPreset preset, const PhysicsSettings& given);
/// Whether makePhysics() makes one.
bool hasPhysics();
/// Whether there are renderers, and FrameLoop::draw().
bool hasRenderer();

}  // namespace rubble
