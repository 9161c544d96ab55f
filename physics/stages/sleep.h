#pragma once
#include <span>

#include "physics/collision/manifold.h"
#include "physics/stages/physics_bodies.h"
#include "physics/stages/physics_joints.h"
#include "physics/stages/physics_settings.h"

namespace rubble {

/// Puts bodies to sleep that have rested long enough, jointed ones in groups. See sleep.cpp for the rule. manifolds: of
/// the step. solverBodies: the number of bodies in the solver.
void putToSleep(PhysicsBodies& bodies, std::span<Manifold* const> manifolds, const PhysicsJoints& joints,
                const PhysicsSettings& settings, glm::dvec3 gravity, size_t solverBodies);
/// Wakes the sleeping bodies that touch a body which has moved.
void wakeTouched(PhysicsBodies& bodies);

}  // namespace rubble
