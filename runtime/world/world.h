#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/world/edits/edit.h"
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/level/level.h"
#include "runtime/world/objects/body_mass.h"
#include "runtime/world/objects/joint_attachment.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/queries/voxel_accounting.h"
#include "runtime/world/queries/world_hash.h"
#include "runtime/world/state/load_level.h"
#include "runtime/world/state/to_level.h"
#include "runtime/world/state/world_data.h"

namespace rubble {

class UndoHistory;
struct WorldDelta;

/// The voxel world: bodies, shapes, lights and groups. Edits go in, one journal of changes comes out.
/// Owned by the main thread. Destruction is in integers and in slot order: the same edits give the same bytes.
/// Questions about it are free functions that take a const World, or the const WorldData that it converts to:
/// transforms (shapeToWorld), bodyMass, voxelAccounting, hashes, rays and overlaps (queries/query.h), fires
/// (state/fires.h).
class World {
public:
    /// An empty world. `id`, 1 to 255, is in all its handles: those of another world are stale here. A world that gets
    /// the id of one that is gone begins with a `firstGeneration` above all of its handles: see highestGeneration().
    explicit World(uint8_t id = 1, uint32_t firstGeneration = 1);
    ~World();
    /// A copy with the same id: handles of one are valid in the other. Costs the number of objects, not of voxels.
    World(const World&);
    /// Leaves the other one empty.
    World(World&&) noexcept;
    World& operator=(const World&);
    World& operator=(World&&) noexcept;

    /// Replaces everything by the level, and all handles from before go stale; the next applyEdits() reports
    /// levelReplaced. Undo starts again.
    void load(const Level& level);
    /// What a step does beside its edits. Nothing: no time passes, no piece comes off, nothing breaks under load, and
    /// what is made counts as brought by the level; for editors.
    enum class Follows : uint8_t { All, Nothing };
    /// One step: undo or redo, then the edits in their order, then all that follows from them and from time. Counts the
    /// step. Invalid edits are logged and do nothing. damage: what impacts of the step before do; it comes before the
    /// edits, and an undo or redo drops it, because its impacts are undone.
    FrameChanges applyEdits(const Edits& edits, const Edits& damage = {}, Follows follows = Follows::All);
    /// A step whose outcome is known, instead of applyEdits(): nothing is decided here, undo and the analyses of stress
    /// start again. Null: nothing happened in it.
    FrameChanges applyDelta(std::optional<WorldDelta> delta);

    /// Takes over the motion of bodies from physics. Stale handles are skipped. step: after which it came, since which
    /// those rest that fell asleep; none: the last.
    void setPoses(std::span<const BodyPose> poses, std::optional<uint64_t> step = std::nullopt);
    /// Takes over the motion of characters from physics. Stale handles are skipped.
    void setCharacters(std::span<const CharacterMove> moves);
    /// Takes over the points of ropes from physics. Ropes that are gone or have another number of points are skipped.
    void setRopes(std::span<const RopeMotion> ropes);

    /// A copy of all that decides what happens next.
    WorldState state() const { return m_data; }
    /// Makes this the World that `state` was taken of: everything before is gone, all handles are those of the state.
    /// The next applyEdits() reports levelReplaced. Undo starts again.
    void setState(WorldState state);
    /// Changes settings between steps; a recording needs a SettingsEdit instead.
    void setSettings(const WorldSettings& settings);
    /// Drops work that is begun and no state: stress analyses and pending connectivity tests start again. A save does
    /// that in the running game too, so that it goes on like one that was loaded. dropMarks: undo starts again too, as
    /// for a recording, because its replay knows nothing from before.
    void resetCaches(bool dropMarks = false);

    /// State and indexes, to read.
    const WorldData& data() const { return m_data; }
    /// The number that all handles of this world carry.
    uint8_t id() const { return m_data.id; }
    /// Steps done since the level was loaded.
    uint64_t step() const { return m_data.step; }
    /// How the world breaks, burns and remembers.
    const WorldSettings& settings() const { return m_data.settings; }
    /// A hash of all that decides what happens next; see stateHash().
    uint64_t hash() const { return stateHash(m_data); }

    /// Bodies by handle, in slot order.
    const SlotMap<BodyHandle, Body>& bodies() const { return m_data.bodies; }
    /// Shapes by handle, in slot order.
    const SlotMap<ShapeHandle, Shape>& shapes() const { return m_data.shapes; }
    /// Lights by handle, in slot order.
    const SlotMap<LightHandle, Light>& lights() const { return m_data.lights; }
    /// Light groups by handle, in slot order.
    const SlotMap<LightGroupHandle, LightGroup>& lightGroups() const { return m_data.groups; }
    /// Bodies of water by handle, in slot order.
    const SlotMap<WaterHandle, Water>& waters() const { return m_data.waters; }
    /// Triggers by handle, in slot order.
    const SlotMap<TriggerHandle, Trigger>& triggers() const { return m_data.triggers; }
    /// Characters by handle, in slot order.
    const SlotMap<CharacterHandle, Character>& characters() const { return m_data.characters; }
    /// Joints by handle, in slot order.
    const SlotMap<JointHandle, Joint>& joints() const { return m_data.joints; }
    /// The level's materials.
    const MaterialTable& materials() const { return m_data.materials; }
    /// Sky, sun, air, exposure and gravity.
    const Environment& environment() const { return m_data.environment; }

    operator const WorldData&() const { return m_data; }

private:
    friend WorldObjects& objectsToReserve(World& world);
    friend void setHostData(World& world, const std::string& name, std::string bytes);
    friend std::optional<bool> differsFromMark(const World& world);
    bool runHistory(const Edits& edits, FrameChanges& changes, bool wasUndoOrRedo);
    void resetSearches(const FrameChanges& changes);
    FrameChanges beginStep();

    WorldData m_data;
    std::vector<UndoHistory> m_undo;  ///< one, or none if nothing is to be remembered
};

/// Keeps bytes under a name with the game; none: forgets them. Nothing in the world follows from them.
void setHostData(World& world, const std::string& name, std::string bytes);

/// Whether resolvedHash() is another one than at the last undo mark, undo or redo; none: no marks are kept.
std::optional<bool> differsFromMark(const World& world);

/// The slot maps of a world, to reserve handles in and for nothing else.
inline WorldObjects& objectsToReserve(World& world) {
    return world.m_data;
}
/// Reserves the handle of something that an edit for the next step makes (Edit::made): an edit for that step may name
/// it already. Empty if the map is full.
template <class Handle, class T>
Handle reserveHandle(World& world, SlotMap<Handle, T> WorldObjects::*map) {
    return (objectsToReserve(world).*map).reserve();
}
/// Whether so many more handles can be reserved; reserving them takes no memory then.
template <class Handle, class T>
bool makeRoomForHandles(World& world, SlotMap<Handle, T> WorldObjects::*map, size_t count) {
    return (objectsToReserve(world).*map).makeRoom(count);
}
/// Reserves the handles of edits that another copy of this world has reserved, in their order.
void claimHandles(World& world, const Edits& edits);

}  // namespace rubble
