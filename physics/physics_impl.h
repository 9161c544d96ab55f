#pragma once
#include <vector>

#include "physics/physics_world.h"
#include "physics/stages/contact_detection.h"
#include "physics/stages/continuous_collision.h"
#include "physics/stages/ground.h"
#include "physics/stages/loads.h"
#include "physics/stages/physics_bodies.h"
#include "physics/stages/physics_characters.h"
#include "physics/stages/physics_joints.h"
#include "physics/stages/step_solver.h"
#include "physics/water/water.h"
#include "runtime/world/impacts/impact.h"

namespace rubble {

/// What PhysicsWorld holds: the stages of a step with their state. apply_changes.cpp takes over what World changed,
/// physics_world.cpp runs a step.
struct PhysicsWorld::Impl {
    /// An empty world.
    explicit Impl(const PhysicsSettings& given) : settings(given) { bodies.budget().setWakes(given.wakesPerStep); }

    /// Creates everything, in slot order.
    void load(const World& world);
    /// Takes over all changes but impulses.
    void applyChanges(const FrameChanges& changes, const World& world);
    /// Applies the impulses of the changes, and quarantines bodies that they made invalid.
    void applyImpulses(const FrameChanges& changes);
    /// Takes over World's gravity, and wakes all bodies if it has changed.
    void setGravity(const World& world);

    PhysicsSettings settings;
    glm::dvec3 gravity{0.0};  ///< m/s2
    PhysicsBodies bodies;
    Ground ground;
    PhysicsJoints joints;
    WaterVolumes waters;
    PhysicsCharacters characters;
    ContactDetection contacts;
    Loads loads;
    StepSolver solver;
    ContinuousCollision continuous;
    std::vector<BodyPose> poses;  ///< of the last step
    std::vector<Impact> impacts;  ///< of the last step
    double work = 0.0;            ///< joules: PhysicsStats::work
};

}  // namespace rubble
