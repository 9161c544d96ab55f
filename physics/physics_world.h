#pragma once
#include <memory>
#include <span>
#include <vector>

#include "physics/bodies/limits.h"
#include "physics/stages/physics_settings.h"
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/impacts/impact.h"
#include "runtime/world/impacts/reported_contact.h"
#include "runtime/world/world.h"

namespace rubble {

struct PhysicsStats {
    int bodies = 0, awake = 0;    ///< dynamic bodies
    int candidates = 0;           ///< pairs of objects whose bounds met in the last step
    int pairs = 0, contacts = 0;  ///< pairs of objects in contact, and their points, in the last step
    int crowded = 0;              ///< awake bodies that are in one place with many others: they have coarser contacts
    int waiting = 0;              ///< sleeping bodies that wait to wake: see PhysicsSettings::wakesPerStep
    int leftOut = 0;        ///< pairs of crowded bodies that were not looked at in the last step, some counted for both
    int bricksLeftOut = 0;  ///< of large surfaces, that may touch and were not searched in the last step
    LimitCounts clamped{};  ///< how often each limit was exceeded, since the beginning
    /// Joules that motors, springs, winches, water and characters gave the bodies in the last step; infinite with a
    /// grab. All else can only take energy from them.
    double work = 0.0;
};

class PhysicsReports;

/// Rigid bodies made of voxels, with joints, ropes, water and characters. It follows a World: load() begins, apply()
/// takes over its changes, step() moves the bodies, and copyMotion() writes the result back. Positions are double; each
/// pair is computed in float about one of its bodies. The same changes and steps give the same bits, with the same
/// build and any number of threads. Its functions are virtual so that a library without physics, which never makes one,
/// links without it. [main-thread]
class PhysicsWorld {
public:
    /// Empty until load().
    explicit PhysicsWorld(const PhysicsSettings& settings = {});
    virtual ~PhysicsWorld();
    PhysicsWorld(const PhysicsWorld&) = delete;
    PhysicsWorld& operator=(const PhysicsWorld&) = delete;

    /// Creates everything from World as it is between two steps, in slot order; nothing of the past remains but the
    /// counts of stats(). A World whose level was replaced is loaded before its next applyEdits(), so that the edits of
    /// that step wake what they wake in any other.
    virtual void load(const World& world);
    /// Takes over what World changed: bodies, shapes, joints, waters, characters, gravity, then impulses. A new piece
    /// starts with the motion that World gave it.
    virtual void apply(const FrameChanges& changes, const World& world);
    /// Other settings from the next step on.
    virtual void setSettings(const PhysicsSettings& settings);
    /// Moves everything by settings.stepSeconds. What the functions below return is valid until the next step().
    virtual void step();
    /// Bodies that moved, fell asleep, woke or began to wait to wake in the last step, in slot order.
    virtual std::span<const BodyPose> poses() const;
    /// Characters that moved or changed in the last step, in slot order.
    virtual std::span<const CharacterMove> characters() const;
    /// Impacts above the settings' threshold in the last step, one for each pair of bodies, in a fixed order. Normals
    /// point from `other` to `body`.
    virtual std::span<const Impact> impacts() const;
    /// Joints whose force or torque in the last step was more than they can stand, in slot order.
    virtual std::span<const JointHandle> jointBreaks() const;
    /// Ropes that moved in the last step, in slot order.
    virtual std::span<const RopeMotion> ropes() const;
    /// What to report of steps from the next one on; by default nothing, at no cost.
    virtual void report(const ReportFilter& filter);
    /// Contacts of the last step that were asked for, in a fixed order.
    virtual std::span<const ReportedContact> contacts() const;
    /// Bodies that got into water in the last step, if that was asked for, in slot order.
    virtual std::span<const WaterEntry> waterEntries() const;
    /// Counts of now and of the last step.
    virtual PhysicsStats stats() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
    std::unique_ptr<PhysicsReports> m_reports;  ///< null: nothing is asked for
};

/// Writes to World what moved in the last step: the poses of bodies, ropes and characters.
inline void copyMotion(const PhysicsWorld& physics, World& world) {
    world.setPoses(physics.poses());
    world.setRopes(physics.ropes());
    world.setCharacters(physics.characters());
}

}  // namespace rubble
