#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/world/frame_changes.h"
#include "runtime/world/world.h"

namespace rubble {

struct PhysicsSettings {
    int substeps = 2;  ///< of 1/60 s
    int solverIterations = 10;
    double sleepVelocity = 0.02;         ///< m/s of drift, averaged over sleepTime, below which a touching body falls asleep
    double sleepAngularVelocity = 0.04;  ///< rad/s
    double sleepTime = 0.5;              ///< s of calm before it does
    double impactThreshold = 50.0;       ///< N s below which a contact is not reported
    double impactSpeed = 0.5;            ///< m/s of approach below which it counts as resting and is not reported
};

struct PhysicsFigures {
    int bodies = 0, awake = 0, contacts = 0, colliderBoxes = 0;
};

/// Bullet's world behind one wall. Bullet counts in float from an origin chosen when a level is loaded (the middle of its
/// bodies, whole metres), so a level anywhere keeps its precision; World and this interface are double. [main-thread]
class PhysicsWorld {
public:
    explicit PhysicsWorld(const PhysicsSettings& settings = {});
    ~PhysicsWorld();
    PhysicsWorld(const PhysicsWorld&) = delete;
    PhysicsWorld& operator=(const PhysicsWorld&) = delete;

    /// Creates, destroys and re-shapes bodies as the journal says, then applies its impulses. Colliders are rebuilt off
    /// to the side and swapped; a piece starts with its parent's motion (v + w x r, w), which World has already set.
    /// anew: everything is made from the World in slot order, as after levelReplaced: nothing of the past counts any more.
    void apply(const FrameChanges& changes, const World& world, bool anew = false);
    /// 1/60 s.
    void step();
    /// Bodies that moved, fell asleep or woke in the last step, in slot order; valid until the next step().
    std::span<const BodyPose> poses() const;
    /// Hits harder than the threshold in the last step, one for each pair of bodies and substep, in a fixed order; the
    /// normal points from `other` to `body`. Valid until the next step().
    std::span<const Impact> impacts() const;
    PhysicsFigures figures() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace rubble
