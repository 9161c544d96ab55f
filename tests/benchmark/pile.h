#pragma once
#include <functional>
#include <vector>

#include "physics/physics_world.h"
#include "runtime/world/world.h"
#include "tests/physics/baseline/bullet_compounds.h"
#include "tests/support/cpu_time.h"

namespace rubble {

/// Milliseconds of wall-clock time in f().
double wallMs(const std::function<void()>& f);
/// percent: 0 to 100.
double percentile(std::vector<double> values, size_t percent);
/// The arithmetic mean.
double mean(const std::vector<double>& values);
/// The middle value.
double median(const std::vector<double>& values);
/// The settings, but that nothing sleeps.
PhysicsSettings sleepless(PhysicsSettings settings = {});

/// A level in our physics; the first `woken` bodies are awake from the start.
struct Pile {
    /// Loads it, and wakes them.
    Pile(const Level& level, const PhysicsSettings& settings, size_t woken = ~size_t(0));
    /// Moves everything by 1/60 s.
    void step();
    /// Of the bodies' frames, by body of the level, world.
    std::vector<Pose> poses() const;
    World world;
    PhysicsWorld physics;
    std::vector<BodyHandle> handles;  ///< by body of the level
};

/// Of the bodies' frames, by body of the level, world.
std::vector<Pose> posesOf(const BulletCompounds& bullet, const Level& level);

}  // namespace rubble
