#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"
#include "runtime/core/slot_map.h"
#include "runtime/voxel/mass_properties.h"
#include "runtime/voxel/voxel_grid.h"
#include "runtime/world/state/bounds_tree.h"
#include "runtime/world/state/debris_queue.h"
#include "runtime/world/edits/edit.h"
#include "runtime/world/state/fire_state.h"
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/objects/joint.h"
#include "runtime/world/state/joint_index.h"
#include "runtime/world/level/level.h"
#include "runtime/world/state/pending_split.h"
#include "runtime/world/settings/world_settings.h"
#include "runtime/world/state/world_stress.h"

namespace rubble {

/// A voxel grid on a body.
struct Shape {
    std::string name;
    BodyHandle body;
    Pose local;              ///< in its body; the grid's corner is the origin
    float voxelSize = 0.1f;  ///< metres
    VoxelGrid grid;
    PaletteRef palette;
    PaintColorsRef paintColors;    ///< null: nothing is painted
    MassMoments moments;           ///< of the grid, always up to date
    std::vector<CellBox> anchors;  ///< cells that hold a static shape to the world
    std::vector<std::string> tags;
    bool isPiece = false;         ///< came off something
    bool knownConnected = false;  ///< known since its last split: a cut need only look around itself
    bool loadBearing = true;      ///< false: left out of the stress analysis
    float strength = 1.0f;        ///< multiple of its materials' strengths
    uint8_t collisionLayer = 1;   ///< bits; two shapes touch if each one's layer is in the other's mask
    uint8_t collisionMask = 255;
};

/// A rigid body: a frame that shapes are fixed to. Its origin is not its centre of mass.
struct Body {
    std::string name;
    Pose pose;                        ///< metres, world
    glm::dvec3 velocity{0.0};         ///< of the centre of mass, m/s
    glm::dvec3 angularVelocity{0.0};  ///< rad/s, world axes
    bool isStatic = true;
    bool asleep = false;
    std::vector<ShapeHandle> shapes;
    std::vector<std::string> tags;
    bool settled = false;       ///< asleep for so long that only what breaks or moves near it wakes it
    bool broken = false;        ///< has lost voxels
    uint64_t createdStep = 0;   ///< step; 0: came with the level
    uint64_t restingSince = 0;  ///< step at which it fell asleep; kept while asleep only
};

/// A body's new state, as physics hands it over.
struct BodyPose {
    BodyHandle body;
    Pose pose;
    glm::dvec3 velocity{0.0};
    glm::dvec3 angularVelocity{0.0};
    bool asleep = false;
};

/// A contact that hit hard, as physics reports it.
struct Impact {
    BodyHandle body;
    BodyHandle other;
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};  ///< the way that `body` is pushed
    double impulse = 0.0;    ///< N s
    double speed = 0.0;      ///< m/s at which they met
};

/// Where a rope's points are, as physics hands them over.
struct RopeMotion {
    JointHandle rope;
    std::span<const RopePoint> points;
};

struct WorldHit {
    bool hit = false;
    double distance = 0.0;  ///< metres
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};
    ShapeHandle shape;
    glm::ivec3 cell{0};
    uint8_t entry = 0;
};

/// Where every voxel of the level is now. imported = standing + inPieces + removed, always.
struct VoxelAccounting {
    uint64_t imported = 0, standing = 0, inPieces = 0, removed = 0;
    bool balances() const { return imported == standing + inPieces + removed; }
};

class UndoHistory;
struct WorldDelta;
struct WorldState;

/// The voxel world: bodies, shapes, lights and groups. Edits go in, one journal of changes comes out.
/// Owned by the main thread. Destruction is in integers and in slot order: the same edits give the same bytes.
class World {
public:
    explicit World(uint8_t id = 1);
    ~World();
    World(const World&);
    World(World&&) noexcept;
    World& operator=(const World&);
    World& operator=(World&&) noexcept;

    /// Replaces everything by the level, and all handles from before go stale; the next applyEdits() reports
    /// levelReplaced.
    void load(const Level& level);
    /// The whole world as data: load(toLevel()) gives the same hash of bodies and voxels.
    Level toLevel() const;

    /// One step: carves, splits, paints, puts light groups out. Counts the step.
    FrameChanges applyEdits(const Edits& edits);
    void setPoses(std::span<const BodyPose> poses);
    void setCharacters(std::span<const CharacterMove> moves);
    void setRopes(std::span<const RopeMotion> ropes);
    /// The edits that impacts cause by their force; see WorldSettings.
    Edits damageFrom(std::span<const Impact> impacts) const;
    /// All that decides what happens next, and the World that has it: everything before is gone, all handles are those
    /// of the state. The next applyEdits() reports levelReplaced. Undo starts anew.
    WorldState state() const;
    void setState(WorldState state);
    /// Puts these objects in their slots, journals it and returns what was there.
    WorldDelta swap(WorldDelta target, FrameChanges& changes);
    /// A step whose outcome is known, instead of applyEdits(): nothing is decided here. Null: nothing happened in it.
    FrameChanges applyDelta(std::optional<WorldDelta> delta);

    uint8_t id() const { return m_id; }
    /// Voxels that the level brought, and those that are gone.
    uint64_t imported() const { return m_imported; }
    uint64_t removed() const { return m_removed; }

    const WorldSettings& settings() const { return m_settings; }
    void setSettings(const WorldSettings& settings);

    /// Forgets what is only kept to save work, and begins it anew: stress analyses. A save does that in the running
    /// game too, so that it goes on like one that was loaded.
    void resetCaches();
    /// The stress analyses; null while StressSettings are off.
    const WorldStress* stress() const { return m_stress ? &*m_stress : nullptr; }

    const SlotMap<BodyHandle, Body>& bodies() const { return m_bodies; }
    const SlotMap<ShapeHandle, Shape>& shapes() const { return m_shapes; }
    const SlotMap<LightHandle, Light>& lights() const { return m_lights; }
    const SlotMap<LightGroupHandle, LightGroup>& lightGroups() const { return m_groups; }
    const SlotMap<WaterHandle, Water>& waters() const { return m_waters; }
    const SlotMap<TriggerHandle, Trigger>& triggers() const { return m_triggers; }
    const SlotMap<CharacterHandle, Character>& characters() const { return m_characters; }
    /// Bounds of the shapes, by slot, to be looked through by queries.
    const BoundsTree& shapeBounds() const { return m_shapeBounds; }
    const SlotMap<JointHandle, Joint>& joints() const { return m_joints; }
    /// Those that hold on to a shape, in slot order.
    std::span<const JointHandle> jointsOf(ShapeHandle shape) const { return m_jointIndex.of(shape); }
    /// Ropes, and grabs, in slot order.
    const JointIndex& jointIndex() const { return m_jointIndex; }
    /// Whether joints lead from a body to one that is static, or to the world.
    bool isJointedToStatic(BodyHandle body) const;
    /// An end of a joint -> world.
    Pose jointToWorld(const JointEnd& end) const;
    const MaterialTable& materials() const { return m_materials; }
    const Environment& environment() const { return m_environment; }
    const std::vector<std::pair<std::string, Pose>>& locations() const { return m_locations; }

    /// Grid corner -> world.
    Pose shapeToWorld(ShapeHandle shape) const;
    /// A light's frame -> world.
    Pose lightToWorld(const Light& light) const;
    /// Mass of all shapes of a body in the body's frame.
    MassProperties bodyMass(BodyHandle body) const;
    /// Shapes whose bounds are within `radius` metres of a point, and perhaps a few more nearby, in slot order. Costs
    /// what is found, not what exists.
    std::vector<ShapeHandle> shapesNear(glm::dvec3 point, double radius) const;
    /// First voxel that a world ray touches, up to maxDistance metres; direction need not be normalised.
    WorldHit raycast(glm::dvec3 origin, glm::dvec3 direction, double maxDistance) const;
    VoxelAccounting voxelAccounting() const;
    /// The pieces under the budgets of DebrisSettings.
    const DebrisQueue& debris() const { return m_debris; }
    /// What burns, in slot order; for events see FrameChanges. Costs what is hot.
    std::vector<Fire> fires() const;
    std::optional<Fire> closestFire(glm::dvec3 position, double maxDistance) const;
    /// Share of its strength that char and heat have left to a brick.
    double remainingStrength(ShapeHandle shape, glm::ivec3 brick) const;
    /// All heat as plain data, for files and undo; the shapes of what is put back must be there.
    const FireState& fire() const { return m_fire; }
    void setFire(FireState fire) { m_fire = std::move(fire); }
    uint64_t step() const { return m_step; }
    /// Of everything that matters to what happens next: voxels, palettes, bodies, velocities, lights, groups, weather,
    /// heat, in slot order. The number of the world and the generations of its slots do not matter to that.
    uint64_t hash() const;
    /// The same without the number of the step, heat, and analyses that go on over steps: what a recording's outcome
    /// comes to, and what an undo goes back to.
    uint64_t resolvedHash() const;
    /// Of voxels, palettes and light groups alone: the same on every machine.
    uint64_t voxelHash() const;

private:
    friend class EditStep;
    friend class WorldBaseline;
    bool runHistory(const Edits& edits, FrameChanges& changes);
    void clear();
    /// Makes the sun's direction one of length 1.
    void setEnvironment(Environment environment);
    /// As it is; returns what was there.
    Environment swapEnvironment(const Environment& environment);
    /// Brings the index of places up to date: to be called when a shape is made, resized or moved, and when it goes.
    void updateShapeBounds(ShapeHandle shape);
    void removeShapeBounds(ShapeHandle shape) { m_shapeBounds.remove(shape.slot()); }
    /// Brings the list of debris up to date with a body, which may be gone or no debris.
    void updateDebris(BodyHandle body);
    bool hasDebrisWork() const;
    /// Begins the stress analysis of every standing shape anew, or ends it if it is off.
    void restartStress();
    /// Finds the voxels that hold a joint and the points of a rope; what is missing, or nothing.
    std::string resolveJoint(Joint& joint) const;
    JointHandle addJoint(Joint joint);
    void rebuildJointIndex();
    bool hasActiveWinch() const;  ///< a winch turns
    void journalJoints(const WorldDelta& before, FrameChanges& changes);
    /// Whether wire leads from the group's supply to a voxel of it.
    bool isPowered(LightGroupHandle handle, const LightGroup& group) const;
    void connectPowerSupplies();
    void addImpactDamage(const Impact& impact, BodyHandle body, Edits& out) const;
    void addImpactLoad(const Impact& impact, BodyHandle body, Edits& out) const;
    void addStress(ShapeHandle shape);
    void resetSearches(const FrameChanges& changes);
    /// Fills in initialVoxels of groups that do not bring it.
    void countGroupVoxels();

    uint8_t m_id;
    uint64_t m_step = 0;
    bool m_levelReplaced = false;
    SlotMap<BodyHandle, Body> m_bodies;
    SlotMap<ShapeHandle, Shape> m_shapes;
    SlotMap<LightHandle, Light> m_lights;
    SlotMap<LightGroupHandle, LightGroup> m_groups;
    SlotMap<WaterHandle, Water> m_waters;
    SlotMap<TriggerHandle, Trigger> m_triggers;
    SlotMap<CharacterHandle, Character> m_characters;
    BoundsTree m_shapeBounds;               ///< of shapes, by slot
    BoundsTree m_triggerBounds;             ///< by slot
    std::vector<BodyHandle> m_movedBodies;  ///< since triggers were last looked at; empty if there are none
    SlotMap<JointHandle, Joint> m_joints;
    JointIndex m_jointIndex;
    DebrisQueue m_debris;
    std::vector<BodyHandle> m_revived;  ///< settled bodies that physics has woken since the last step
    MaterialTable m_materials = defaultMaterials();
    FireState m_fire;
    Environment m_environment;
    WorldSettings m_settings;
    std::vector<std::pair<std::string, Pose>> m_locations;
    uint8_t m_wire = 0;               ///< the material of wire; 0: none
    uint32_t m_flickeringGroups = 0;  ///< that flicker
    uint64_t m_imported = 0, m_removed = 0;
    std::vector<PendingSplit> m_pendingSplits;
    std::vector<UndoHistory> m_undo;      ///< one, or none if nothing is to be remembered
    std::optional<WorldStress> m_stress;  ///< none: StressSettings are off
    std::string m_name;
};

}  // namespace rubble
