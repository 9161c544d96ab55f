#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/destruction/cross_section.h"
#include "runtime/voxel/brick.h"
#include "runtime/voxel/palette.h"
#include "runtime/world/objects/joint.h"
#include "runtime/world/objects/trigger.h"

namespace rubble {

/// One brick of a shape after the step; null = now empty.
struct BrickChange {
    ShapeHandle shape;
    glm::ivec3 brick;
    BrickRef content;
};

/// Voxels of one palette entry that were removed from one shape.
struct RemovedVoxels {
    ShapeHandle shape;
    uint8_t entry;
    uint8_t material;
    std::array<uint8_t, 3> color;
    uint64_t count;
};

/// Where voxels went that are no more: particles. Every removed voxel is in exactly one cloud.
struct DustCloud {
    glm::dvec3 position;  ///< its middle, world
    double radius;        ///< metres
    glm::vec3 velocity;   ///< of what they were part of, m/s
    std::array<uint8_t, 3> color;
    uint8_t material;
    uint64_t count;  ///< voxels
};

/// A charge went off.
struct Blast {
    glm::dvec3 position;  ///< world
    double size;          ///< as in ExplodeEdit
};

/// How a piece set out.
struct PieceMotion {
    glm::dvec3 center{0.0};  ///< of mass, world
    glm::dvec3 velocity{0.0}, angularVelocity{0.0};
    double mass = 0.0;  ///< kg
};

/// A shape came apart: what broke out of it, or, in a record of its own, what it no longer held. The parent handle
/// lives on in the anchored, largest or lowest piece; children are new shapes, each on a body of its own.
/// parentOffset[i]: the cell of the parent at which child i's cell 0 lies.
struct ShapeSplit {
    ShapeHandle parent;
    std::vector<ShapeHandle> children;
    std::vector<glm::ivec3> parentOffset;
    std::vector<PieceMotion> motions;  ///< of the children, before anything pushes them
};

struct ImpulseApplied {
    BodyHandle body;
    glm::dvec3 position;
    glm::dvec3 impulse;
};

/// A section of a standing shape that gave way under its load.
struct CrackOpened {
    ShapeHandle shape;
    glm::dvec3 position;  ///< world, metres
    glm::dvec3 normal;    ///< of the section, world
    uint8_t material;
    FailureMode cause;
    uint64_t voxels;  ///< that it took
};

/// A brick that caught fire, or went out.
struct FireEvent {
    ShapeHandle shape;
    glm::ivec3 brick;
    glm::dvec3 position;  ///< world, metres
};

/// An end of a joint went with its voxel into another shape.
struct JointMoved {
    JointHandle joint;
    ShapeHandle from, to;
};

/// A joint that is no more, but for the two parts of a rope that was cut: the first keeps the handle.
struct JointBroken {
    JointHandle joint;
    JointBreak reason;
    glm::dvec3 position;  ///< world
};

/// Everything that one step of edits changed: the one journal that physics, shadow, renderer, recording and undo read.
/// Handles refer to the World after the edits, except in the destroyed lists. Each list is in the order it happened;
/// a step in which nothing happens allocates nothing.
struct FrameChanges {
    uint64_t step = 0;
    bool levelReplaced = false;  ///< everything before is gone: start from the World
    std::vector<BodyHandle> bodiesCreated;
    std::vector<BodyHandle> bodiesDestroyed;
    std::vector<ShapeHandle> shapesCreated;  ///< read their grid from the World: their bricks are not in `bricks`
    std::vector<ShapeHandle>
        shapesDestroyed;  ///< comes before shapesCreated: a shape with a new frame of cells is in both
    std::vector<ShapeSplit> splits;
    std::vector<BrickChange> bricks;    ///< carved or painted, each brick once, of shapes that were there before
    std::vector<ShapeHandle> carved;    ///< shapes whose occupancy (so mass and collider) changed, each once
    std::vector<ShapeHandle> palettes;  ///< shapes whose palette or colours of paint changed
    std::vector<ShapeHandle>
        unanchored;  ///< shapes that lost their last anchor: now on a new body of their own, in bodiesCreated
    std::vector<RemovedVoxels> removed;  ///< a record for each edit, shape and entry
    std::vector<LightHandle> lights;  ///< lights created, changed, moved to another shape or body, switched or removed
    std::vector<LightGroupHandle> groupsOut;
    std::vector<ImpulseApplied> impulses;
    std::vector<DustCloud> dust;           ///< all that is in `removed`, with its place
    std::vector<Blast> blasts;             ///< charges that went off, in order
    std::vector<BodyHandle> broken;        ///< bodies that lost voxels for the first time
    std::vector<BodyHandle> settled;       ///< pieces that have come to rest for good
    std::vector<BodyHandle> unsettled;     ///< settled pieces that something has woken
    std::vector<LightGroupHandle> groups;  ///< light groups that lost voxels, went out or came back
    std::vector<BodyHandle> teleported;    ///< bodies that were put somewhere or given another motion: undo and replay
    uint64_t paintedVoxels = 0;
    uint64_t paintMerges = 0;  ///< colours that found no free entry and took the nearest
    std::vector<FireEvent> firesLit;
    std::vector<FireEvent> firesOut;          ///< a shape that is destroyed takes its fires along without a word
    bool firesChanged = false;                ///< something burns, or did until this step
    uint64_t firesRefused = 0;                ///< bricks hot enough to updateFires, beyond FireSettings::maxFires
    uint64_t heatLost = 0;                    ///< deposits of heat beyond FireSettings::maxHot
    std::vector<CrackOpened> cracks;          ///< their voxels are in `removed` too
    std::vector<ShapeHandle> filters;         ///< shapes with another collision layer or mask
    std::vector<WaterHandle> waters;          ///< created, changed or removed
    std::vector<TriggerHandle> triggers;      ///< created, removed, or holding other bodies
    std::vector<CharacterHandle> characters;  ///< created, removed, placed, or wishing something else
    std::vector<TriggerEvent> triggerEvents;  ///< by trigger, then body, in slot order
    std::vector<JointHandle> jointsCreated;   ///< by edits, and the second parts of ropes that were cut
    std::vector<JointMoved> jointsMoved;      ///< to another shape, in a split or merge
    std::vector<JointBroken> jointsBroken;
    std::vector<JointHandle> jointsChanged;  ///< motor, place of an end or length: read it from the World
    std::vector<LightHandle> lightsAdded;    ///< one for each AddLightEdit, in order; an empty handle: it was refused
    bool environmentChanged = false;         ///< read it from the World

    bool empty() const {
        return !levelReplaced && !environmentChanged && bodiesCreated.empty() && bodiesDestroyed.empty() &&
               shapesCreated.empty() && shapesDestroyed.empty() && bricks.empty() && palettes.empty() &&
               lights.empty() && groupsOut.empty() && impulses.empty() && settled.empty() && unsettled.empty() &&
               groups.empty() && teleported.empty() && !firesChanged && filters.empty() && waters.empty() &&
               triggers.empty() && characters.empty() && jointsCreated.empty() && jointsMoved.empty() &&
               jointsBroken.empty() && jointsChanged.empty();
    }
};

}  // namespace rubble
