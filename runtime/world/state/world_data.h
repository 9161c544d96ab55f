#pragma once
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "runtime/core/bounds_tree.h"
#include "runtime/world/state/debris_queue.h"
#include "runtime/world/state/joint_index.h"
#include "runtime/world/state/world_state.h"
#include "runtime/world/state/world_stress.h"

namespace rubble {

/// A world as the stages of a step see it: its state, and indexes over that. The indexes say nothing that the state
/// does not say, but stress analyses, which are work begun. Who changes an object calls the function
/// below that keeps its index up to date. Hosts see all of this only as const, through World::data().
struct WorldData : WorldState {
    /// An empty world with the default materials; `id` is in all its handles, whose generations begin with
    /// `firstGeneration`.
    explicit WorldData(uint8_t id, uint32_t firstGeneration = 1);

    uint8_t id;
    bool levelReplaced = false;           ///< since the last step
    uint8_t wire = 0;                     ///< the material of wire; 0: none
    uint32_t flickeringGroups = 0;        ///< light groups that are about to go out
    BoundsTree shapeBounds;               ///< by slot of the shape
    BoundsTree triggerBounds;             ///< by slot of the trigger
    std::vector<BodyHandle> movedBodies;  ///< since triggers were last updated; empty if there are no triggers
    std::vector<BodyHandle> leftBounds;   ///< found outside since the last step; may hold one twice, or stale ones
    JointIndex jointIndex;
    std::unordered_map<uint64_t, NoteHandle> noteOf;  ///< the notes by the bits of their objects
    DebrisQueue debris;                               ///< the pieces under the budgets of DebrisSettings
    std::optional<WorldStress> stress;                ///< none: StressSettings are off, or a delta came last

    /// Erases all objects and forgets all work; handles from before go stale. Materials, environment, settings, name
    /// and locations stay.
    void clear();
    /// Builds the indexes of objects that were put in place all at once, after clear().
    void rebuildIndexes();

    /// Takes over settings: what counts as debris may change, and stress analyses start again if theirs do.
    void setSettings(const WorldSettings& settings);
    /// Takes over an environment and makes the sun's direction a unit vector; up if it is zero.
    void setEnvironment(Environment environment);
    /// Takes over an environment exactly as it is; returns the one before. Another gravity restarts stress analyses.
    Environment swapEnvironment(const Environment& environment);

    /// To be called when a shape is made, resized or moved.
    void updateShapeBounds(ShapeHandle shape);
    /// To be called before a shape is erased.
    void removeShapeBounds(ShapeHandle shape) { shapeBounds.remove(shape.slot()); }
    /// To be called when a body or its shapes changed; the body may be gone or be no debris. Checks the bounds too.
    void updateDebris(BodyHandle body);
    /// Takes over where the world ends.
    void setBounds(const BoundsSettings& to);
    /// Whether a body is free, has shapes, none of them touches the bounds, and BoundsRule says that it becomes dust.
    bool isOutside(BodyHandle body) const;
    /// Lists a body in leftBounds if it is outside. To be called when it has moved.
    void checkBounds(BodyHandle body);
    /// Inserts a joint, whose ends must be attached (attachJoint()), and lists it in the index.
    JointHandle addJoint(Joint joint);

    /// What edits have said about an object, by the bits of its handle; null: nothing.
    const Note* findNote(uint64_t object) const;
    /// Inserts a note about an object that has none, and lists it in the index.
    NoteHandle addNote(Note note);

    /// Starts the stress analysis of every standing shape again, or ends all of them if they are off.
    void restartStress();
    /// Starts the analysis of one shape if it is static, load-bearing and not too large; stress must be on.
    void addStress(ShapeHandle shape);

    /// Whether a step without edits has something to do.
    bool isBusy() const;

private:
    bool hasDebrisWork() const;
    void indexTriggers();
};

}  // namespace rubble
