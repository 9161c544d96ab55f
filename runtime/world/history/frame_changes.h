#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/destruction/cross_section.h"
#include "runtime/voxel/brick.h"
#include "runtime/voxel/palette.h"
#include "runtime/world/objects/body_constraint.h"
#include "runtime/world/objects/joint.h"
#include "runtime/world/objects/trigger.h"

namespace rubble {

/// One brick of a shape after the step; null: it is empty now.
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

/// Removed voxels, for particles. Every removed voxel is in exactly one cloud.
struct DustCloud {
    glm::dvec3 position;  ///< centre, world
    double radius;        ///< metres
    glm::vec3 velocity;   ///< of the body that they were part of, m/s
    std::array<uint8_t, 3> color;
    uint8_t material;
    uint64_t count;  ///< voxels
};

/// An explosion.
struct Blast {
    glm::dvec3 position;  ///< world
    double size;          ///< as in ExplodeEdit
};

/// How a piece moves when it comes off.
struct PieceMotion {
    glm::dvec3 center{0.0};  ///< of mass, world
    glm::dvec3 velocity{0.0}, angularVelocity{0.0};
    double mass = 0.0;  ///< kg
};

/// Pieces that came off a shape. Fragments of a break and pieces that lost their connection are in records of their
/// own. The parent's handle stays with the anchored component, else the largest; children are new shapes, each on a
/// body of its own, but for those of a SplitShapeEdit. parentOffset[i]: the cell of the parent at which child i's cell
/// 0 lies.
struct ShapeSplit {
    ShapeHandle parent;
    std::vector<ShapeHandle> children;
    std::vector<glm::ivec3> parentOffset;
    std::vector<PieceMotion> motions;  ///< of the children, before impulses
};

/// An impulse on a free body; physics applies it.
struct ImpulseApplied {
    BodyHandle body;
    glm::dvec3 position;  ///< world
    glm::dvec3 impulse;   ///< N s
};

/// A section of a shape that broke under its load or an impact.
struct CrackOpened {
    ShapeHandle shape;
    glm::dvec3 position;  ///< world, metres
    glm::dvec3 normal;    ///< of the section, world
    uint8_t material;
    FailureMode cause;
    uint64_t voxels;  ///< that were removed
};

/// A brick that ignited or went out.
struct FireEvent {
    ShapeHandle shape;
    glm::ivec3 brick;
    glm::dvec3 position;  ///< world, metres
};

/// An end of a joint that followed its voxel into another shape, or of a rope that came loose.
struct JointMoved {
    JointHandle joint;
    ShapeHandle from, to;      ///< to: null: it came loose
    glm::dvec3 position{0.0};  ///< world, where it came loose
};

/// A joint that is gone. Of a rope that was cut the first part keeps the handle.
struct JointBroken {
    JointHandle joint;
    JointBreak reason;
    glm::dvec3 position;  ///< world
};

/// A handle that an edit should have made, which names nothing and never will.
struct RefusedHandle {
    AnyHandle handle;
    std::string reason;
};

/// The journal: everything that one step changed. Physics, shadow volume, renderer, recordings and undo read it and
/// nothing else. Handles refer to the World after the step, except in the destroyed lists. Each list is in the order of
/// events. A step in which nothing happens allocates nothing.
struct FrameChanges {
    uint64_t step = 0;
    bool levelReplaced = false;  ///< everything before is gone: read all from the World
    bool isStill = false;        ///< no time passed: World::Follows::Nothing
    std::vector<BodyHandle> bodiesCreated;
    std::vector<BodyHandle> bodiesDestroyed;
    std::vector<ShapeHandle> shapesCreated;  ///< read their grid from the World: their bricks are not in `bricks`
    /// Before shapesCreated: a shape whose grid got another box is in both, and one that `relocated` has.
    std::vector<ShapeHandle> shapesDestroyed;
    /// Static shapes that have another place, and those that became static or free. They have the voxels that they had,
    /// but for `bricks` and `carved`. In the order of handles.
    std::vector<ShapeHandle> relocated;
    std::vector<ShapeSplit> splits;
    std::vector<BrickChange> bricks;  ///< carved or painted, each brick once, of shapes that existed before, by slot
    /// Shapes whose occupancy or materials changed, so mass and collider too, each once.
    std::vector<ShapeHandle> carved;
    std::vector<ShapeHandle> palettes;  ///< shapes whose palette or paint colours changed
    /// Shapes that lost their last anchor: each is now on a body of its own, which is in bodiesCreated.
    std::vector<ShapeHandle> unanchored;
    std::vector<BodyHandle> lostShapes;  ///< bodies that lost a shape and are still there; some more than once
    std::vector<RemovedVoxels> removed;  ///< one for each edit, shape and entry
    std::vector<LightHandle> lights;  ///< lights created, changed, moved to another shape or body, switched or removed
    std::vector<LightGroupHandle> groupsOut;
    std::vector<ImpulseApplied> impulses;
    std::vector<BodyConstraint> constraints;  ///< of free bodies, for the step of physics that follows
    std::vector<DustCloud> dust;              ///< all voxels of `removed`, with their places; none in a still step
    std::vector<Blast> blasts;                ///< explosions
    std::vector<BodyHandle> broken;           ///< bodies that lost voxels for the first time
    std::vector<BodyHandle> settled;          ///< pieces that settled
    std::vector<BodyHandle> unsettled;        ///< settled pieces that woke
    std::vector<BodyHandle> woken;            ///< bodies that edits woke, or kept from resting on
    std::vector<LightGroupHandle> groups;     ///< light groups that lost voxels, went out or came back
    std::vector<BodyHandle> teleported;       ///< that undo, replay or a host gave a pose or a motion
    uint64_t paintedVoxels = 0;
    uint64_t paintMerges = 0;  ///< colours that took the nearest entry because none was free
    std::vector<FireEvent> firesLit;
    std::vector<FireEvent> firesOut;          ///< without those of destroyed shapes
    bool firesChanged = false;                ///< whether anything burns, or did until this step
    uint64_t firesRefused = 0;                ///< bricks that did not ignite because of FireSettings::maxFires
    uint64_t heatLost = 0;                    ///< deposits of heat that FireSettings::maxHot refused
    std::vector<CrackOpened> cracks;          ///< their voxels are in `removed` too
    std::vector<ShapeHandle> filters;         ///< shapes of which something else changed: collision, strength, anchors
    std::vector<WaterHandle> waters;          ///< created, changed or removed
    std::vector<TriggerHandle> triggers;      ///< created, removed, or with other bodies inside
    std::vector<CharacterHandle> characters;  ///< created, removed, placed, or with another wish
    std::vector<TriggerEvent> triggerEvents;  ///< by trigger, then body, in slot order
    std::vector<JointHandle> jointsCreated;   ///< by edits, and second parts of ropes that were cut
    std::vector<JointMoved> jointsMoved;      ///< by splits and merges
    std::vector<JointBroken> jointsBroken;
    std::vector<JointHandle> jointsChanged;  ///< motor, place of an end, length: read them from the World
    std::vector<NoteHandle> notes;           ///< made, changed or gone; some more than once
    std::vector<LightHandle> lightsAdded;    ///< one for each AddLightEdit; an empty handle: refused
    bool environmentChanged = false;         ///< read it from the World
    bool scriptsChanged = false;             ///< the same
    bool materialsChanged = false;           ///< read them from the World; shapes that are of them are in `carved`
    bool settingsChanged = false;            ///< read them from the World; not for the limit of undo marks alone
    bool isRestored = false;                 ///< by an undo or redo: what is known of the motion before is of no use
    bool keepsSleep = false;                 ///< the step did nothing else: nobody is woken by what it brought back
    std::vector<RefusedHandle> refused;      ///< in the order of their edits; nothing else has to follow them

    /// Whether `relocated` has a shape.
    bool isRelocated(ShapeHandle shape) const { return std::binary_search(relocated.begin(), relocated.end(), shape); }
    /// How much the lists and counts hold, but for the bricks and shapes that edits of voxels share with an undo: what
    /// they remove, paint or make is counted. Grows with all that happens but heat.
    uint64_t entries() const {
        return bodiesCreated.size() + bodiesDestroyed.size() + shapesCreated.size() + shapesDestroyed.size() +
               splits.size() + palettes.size() + unanchored.size() + removed.size() + lights.size() + groupsOut.size() +
               woken.size() + impulses.size() + constraints.size() + paintedVoxels + firesLit.size() + filters.size() +
               waters.size() + triggers.size() + characters.size() + jointsCreated.size() + jointsMoved.size() +
               jointsBroken.size() + jointsChanged.size() + notes.size() + environmentChanged + scriptsChanged +
               materialsChanged + settingsChanged;
    }
    /// Whether nothing changed that physics, renderer, undo or recordings have to follow.
    bool empty() const {
        return !levelReplaced && !environmentChanged && !scriptsChanged && !materialsChanged && !settingsChanged &&
               bodiesCreated.empty() && bodiesDestroyed.empty() && shapesCreated.empty() && shapesDestroyed.empty() &&
               bricks.empty() && palettes.empty() && lights.empty() && groupsOut.empty() && impulses.empty() &&
               constraints.empty() && settled.empty() && unsettled.empty() && woken.empty() && groups.empty() &&
               teleported.empty() && !firesChanged && filters.empty() && waters.empty() && triggers.empty() &&
               characters.empty() && jointsCreated.empty() && jointsMoved.empty() && jointsBroken.empty() &&
               jointsChanged.empty() && notes.empty();
    }
};

}  // namespace rubble
