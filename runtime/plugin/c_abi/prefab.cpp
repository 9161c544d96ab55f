#include <algorithm>
#include <cstring>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "runtime/assets/assets.h"
#include "runtime/assets/file_bytes.h"
#include "runtime/assets/rubble_file.h"
#include "runtime/assets/vox_import.h"
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/world/level/references.h"

namespace rubble::abi {
namespace {

/// A .vdb file may change with the program that reads it: it is read each time.
Result<std::shared_ptr<const Level>> readGiven(const rubble_prefab& given, PrefabCache& known) {
    if (!given.path) {
        const std::span<const uint8_t> bytes(static_cast<const uint8_t*>(given.data), size_t(given.size));
        return known.get(bytes, [&] { return levelFromBytes(bytes, "data"); });
    }
    const std::string path = given.path;
    const bool isVox = endingOf(path) == ".vox";
    if (isVox || endingOf(path) == ".rubble")
        if (const auto bytes = readFileBytes(path, PrefabCache::kMaxMemory))
            return known.get(*bytes,
                             [&] { return isVox ? importVoxBytes(*bytes, path, {}) : levelFromRubble(*bytes, path); });
    Result<Level> level = readLevel(path, given.vdb_tool ? given.vdb_tool : "");
    if (!level) return Error{level.error()};
    return std::make_shared<const Level>(std::move(*level));
}

/// Palettes of a level as those of a world that has other materials, each made once.
class PaletteTranslation {
public:
    PaletteTranslation(const MaterialTable& from, const MaterialTable& to) {
        for (size_t i = 1; i < std::min<size_t>(from.materials.size(), 256); ++i) {
            m_materials[i] = to.find(from.materials[i].name);
            if (!m_materials[i]) m_missing[i] = from.materials[i].name;
        }
    }
    PaletteRef operator()(const PaletteRef& from) {
        if (!from) return nullptr;
        PaletteRef& known = m_known[from.get()];
        if (known) return known;
        auto palette = std::make_shared<Palette>(*from);
        for (PaletteEntry& entry : *palette) {
            if (entry.material && !m_missing[entry.material].empty())
                refuse(RUBBLE_ERROR_ARGUMENT, "the level has the material \"{}\", which the world has not",
                       m_missing[entry.material]);
            entry.material = m_materials[entry.material];
            entry.lightGroup = 0;
        }
        return known = std::move(palette);
    }

private:
    std::array<uint8_t, 256> m_materials{};
    std::array<std::string, 256> m_missing;
    std::unordered_map<const Palette*, PaletteRef> m_known;
};

/// The edits that make what a level holds, with the rows that name it.
class Placement {
public:
    Placement(const Level& level, const Pose& pose, const World& world)
        : m_pose(pose), m_palettes(level.materials, world.materials()) {
        for (const LevelBody& body : level.bodies) addBody(body);
        for (const LevelBody& body : level.bodies) addShapes(body);
        for (const LevelJoint& joint : level.joints) addJoint(joint, tagsOf(level, joint));
        for (const LevelLight& light : level.lights) addLight(light, tagsOf(level, light));
    }
    size_t size() const { return m_made.size(); }

    /// Reserves a handle for each and queues the edits. Queues none of them if the call is refused.
    std::vector<rubble_prefab_row> queue(HostedWorld& hosted) {
        std::vector<rubble_prefab_row> rows(m_made.size());
        makeRoom(hosted);
        for (size_t i = 0; i < m_made.size() && !isRefused(); ++i) {
            Made& made = m_made[i];
            rows[i].kind = made.kind;
            uint64_t* const handle = &rows[i].handle;
            if (made.kind == RUBBLE_PREFAB_BODY) {
                pushMaker(hosted, std::move(made.edit), &WorldObjects::bodies, handle);
            } else if (made.kind == RUBBLE_PREFAB_SHAPE) {
                rows[i].owner = uint32_t(made.on[0]);
                std::get<CreateShapeEdit>(made.edit).body = {rows[made.on[0]].handle};
                pushMaker(hosted, std::move(made.edit), &WorldObjects::shapes, handle);
            } else if (made.kind == RUBBLE_PREFAB_JOINT) {
                for (size_t end = 0; end < 2; ++end)
                    if (made.on[end] != kNone)
                        std::get<AddJointEdit>(made.edit).joint.ends[end].shape = {rows[made.on[end]].handle};
                pushMaker(hosted, std::move(made.edit), &WorldObjects::joints, handle);
            } else {
                if (made.on[0] != kNone) std::get<AddLightEdit>(made.edit).light.shape = {rows[made.on[0]].handle};
                pushMaker(hosted, std::move(made.edit), &WorldObjects::lights, handle);
            }
            for (SetTagEdit& tag : made.tags) {
                if (made.kind == RUBBLE_PREFAB_JOINT) tag.object = JointHandle{*handle};
                if (made.kind == RUBBLE_PREFAB_LIGHT) tag.object = LightHandle{*handle};
                push(hosted, std::move(tag));
            }
        }
        return rows;
    }

private:
    static constexpr size_t kNone = ~size_t(0);
    struct Made {
        uint32_t kind;
        Edit edit;
        std::array<size_t, 2> on{kNone, kNone};  ///< rows of what it is on
        std::vector<SetTagEdit> tags = {};       ///< of what has none in its own data
    };

    static std::vector<SetTagEdit> tagsOf(const Level& level, TaggedKind kind, size_t number) {
        std::vector<SetTagEdit> out;
        for (const LevelTags& each : level.tags)
            if (each.kind == kind && each.number == number)
                for (const std::string& tag : each.tags)
                    out.push_back({.tag = std::string(tagName(tag)), .value = std::string(tagValue(tag))});
        return out;
    }
    static std::vector<SetTagEdit> tagsOf(const Level& level, const LevelJoint& joint) {
        return tagsOf(level, TaggedKind::Joint, size_t(&joint - level.joints.data()));
    }
    static std::vector<SetTagEdit> tagsOf(const Level& level, const LevelLight& light) {
        return tagsOf(level, TaggedKind::Light, size_t(&light - level.lights.data()));
    }

    /// From here on each edit takes no memory. Refuses the call if there are too few handles.
    void makeRoom(HostedWorld& hosted) const {
        std::array<size_t, 4> counts{};
        size_t edits = m_made.size();
        for (const Made& made : m_made) ++counts[made.kind], edits += made.tags.size();
        World& world = hosted.loop.world();
        if (!makeRoomForHandles(world, &WorldObjects::bodies, counts[RUBBLE_PREFAB_BODY]) ||
            !makeRoomForHandles(world, &WorldObjects::shapes, counts[RUBBLE_PREFAB_SHAPE]) ||
            !makeRoomForHandles(world, &WorldObjects::joints, counts[RUBBLE_PREFAB_JOINT]) ||
            !makeRoomForHandles(world, &WorldObjects::lights, counts[RUBBLE_PREFAB_LIGHT]))
            refuse(RUBBLE_ERROR_CAPACITY, "the world is full: expected at most 16,777,215 objects of a kind");
        hosted.loop.edits().makeRoom(edits);
    }
    static bool isLeftOut(const LevelShape& shape) { return shape.hidden || shape.grid.empty(); }
    void addBody(const LevelBody& from) {
        m_bodies.push_back(kNone);
        if (!from.shapes.empty() && std::all_of(from.shapes.begin(), from.shapes.end(), isLeftOut)) return;
        Body body{.name = from.name, .pose = m_pose * from.pose, .isStatic = from.isStatic, .tags = from.tags};
        body.velocity = m_pose.rotation * glm::dvec3(from.velocity);
        body.angularVelocity = m_pose.rotation * glm::dvec3(from.angularVelocity);
        body.gravityScale = from.gravityScale;
        body.linearDamping = from.linearDamping, body.angularDamping = from.angularDamping;
        m_bodies.back() = m_made.size();
        m_made.push_back({RUBBLE_PREFAB_BODY, CreateBodyEdit{std::move(body)}});
    }
    void addShapes(const LevelBody& from) {
        const size_t body = m_bodies[m_nextBody++];
        for (const LevelShape& shape : from.shapes) {
            m_shapes.add(shape.name, isLeftOut(shape) ? 0 : m_made.size() + 1);
            if (isLeftOut(shape)) continue;
            CreateShapeEdit edit;
            static_cast<LevelShape&>(edit.shape) = shape;
            edit.shape.palette = m_palettes(shape.palette);
            m_made.push_back({RUBBLE_PREFAB_SHAPE, std::move(edit), {body, kNone}});
        }
    }
    /// The row of the shape that a light or joint names.
    size_t findShape(const std::string& reference) const {
        const size_t row = m_shapes.find(reference);
        return row ? row - 1 : kNone;
    }
    void addJoint(const LevelJoint& from, std::vector<SetTagEdit> tags) {
        AddJointEdit edit{from.joint};
        std::array<size_t, 2> on{};
        for (size_t end = 0; end < 2; ++end) {
            on[end] = findShape(from.shapeNames[end]);
            if (on[end] == kNone) edit.joint.ends[end].frame = m_pose * edit.joint.ends[end].frame;
            if (on[end] == kNone && !from.shapeNames[end].empty()) return;
        }
        m_made.push_back({RUBBLE_PREFAB_JOINT, std::move(edit), on, std::move(tags)});
    }
    void addLight(const LevelLight& from, std::vector<SetTagEdit> tags) {
        Light light = from.light;
        const size_t on = findShape(from.shapeName);
        if (on == kNone) light.local = m_pose * light.local;
        m_made.push_back({RUBBLE_PREFAB_LIGHT, AddLightEdit{std::move(light)}, {on, kNone}, std::move(tags)});
    }

    Pose m_pose;
    PaletteTranslation m_palettes;
    std::vector<Made> m_made;
    std::vector<size_t> m_bodies;  ///< rows of the level's bodies
    size_t m_nextBody = 0;
    References<size_t> m_shapes;  ///< rows, plus one
};

rubble_result createPrefab(rubble_world world, const rubble_prefab* prefab, rubble_prefab_row* out, uint32_t capacity,
                           uint32_t* count) {
    return inWorld("create_prefab", world, [&](HostedWorld& hosted) {
        if (!isGiven(count, "count")) return;
        *count = 0;
        if (capacity) isGiven(out, "out");
        const rubble_prefab given = readStruct(prefab, "prefab");
        const Pose pose{readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
        if (!given.path) isGiven(given.data, "data");
        if (isRefused()) return;
        const Result<std::shared_ptr<const Level>> read = readGiven(given, hosted.prefabs);
        if (!read) return refuse(RUBBLE_ERROR_FILE, "{}", read.error());
        const Level& level = **read;
        Placement placement(level, pose, hosted.loop.world());
        if (isRefused()) return;
        *count = uint32_t(placement.size());
        if (!capacity) return;
        if (capacity < placement.size())
            return refuse(RUBBLE_ERROR_CAPACITY, "there are {} rows, the array holds {}", placement.size(), capacity);
        const std::vector<rubble_prefab_row> rows = placement.queue(hosted);
        if (!level.scripts.empty()) push(hosted, SetScriptsEdit{level.scripts, true});
        if (!isRefused()) std::copy(rows.begin(), rows.end(), out);
    });
}

}  // namespace

void setPrefabFunctions(rubble_api& api) {
    api.create_prefab = createPrefab;
}

}  // namespace rubble::abi
