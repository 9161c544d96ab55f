#include "runtime/assets/save_file.h"

#include <algorithm>
#include <cstring>
#include <glm/vector_relational.hpp>
#include <new>
#include <set>
#include <type_traits>

#include "runtime/assets/binary_archive.h"
#include "runtime/assets/chunk_file.h"
#include "runtime/assets/file_bytes.h"
#include "runtime/assets/level_validation.h"
#include "runtime/assets/state_fields.h"
#include "runtime/core/planted_fault.h"
#include "runtime/world/objects/joint_attachment.h"
#include "runtime/world/objects/object_errors.h"
#include "runtime/world/queries/notes.h"
#include "runtime/world/settings/settings_error.h"
#include "runtime/world/world.h"

namespace rubble {
namespace {

/// All slots of a map with their generations, empty ones too: handles stay the same in a loaded game.
template <class Handle, class T>
void putSlots(BinaryOutputArchive& out, const SlotMap<Handle, T>& map) {
    out.addMemory(listMemory(map.slots().size(), sizeof(typename SlotMap<Handle, T>::Slot)));
    out.put(uint32_t(map.slots().size()));
    for (const auto& slot : map.slots()) {
        out.put(slot.generation);
        out.put(slot.lastGeneration);
        out.put(slot.value.has_value());
        if (slot.value) out.put(*slot.value);
    }
    out.put(map.freeSlots());
}

template <class Handle, class T>
void getSlots(ByteReader& reader, BinaryInputArchive& in, uint8_t world, SlotMap<Handle, T>& map) {
    using Slot = typename SlotMap<Handle, T>::Slot;
    const uint32_t count = reader.readCount(9, "slots");
    if (!reader.takeMemory(listMemory(count, sizeof(Slot)))) return;
    std::vector<Slot> slots(count);
    for (Slot& slot : slots) {
        in.get(slot.generation);
        in.get(slot.lastGeneration);
        bool isTaken = false;
        in.get(isTaken);
        if (isTaken) in.get(slot.value.emplace());
        if (reader.failed()) return;
    }
    std::vector<uint32_t> free;
    in.get(free);
    map = {world, std::move(slots), free};
}

/// Joints are behind the other fields of the chunk, all other kinds of objects before them.
template <class Map>
constexpr bool kIsJoints = std::is_same_v<std::decay_t<Map>, SlotMap<JointHandle, Joint>>;

std::vector<uint8_t> stateToBytes(const SavedGame& game, PaletteList& palettes, uint64_t& memory) {
    std::vector<uint8_t> bytes;
    BinaryOutputArchive out(bytes, palettes);
    const WorldState& world = game.world;
    out.put(world.name);
    out.put(world.step), out.put(world.imported), out.put(world.removed);
    forEachKind(
        [&](const auto& map) {
            if constexpr (!kIsJoints<decltype(map)>) putSlots(out, map);
        },
        world);
    out.put(world.unsettled);
    out.put(world.materials.materials);
    out.put(world.environment);
    out.put(world.settings);
    out.put(world.bounds);
    out.put(world.footprint);
    out.put(world.made);
    out.put(world.locations);
    out.put(world.fire.fields);
    putSlots(out, world.joints);
    out.put(game.pending);
    memory = out.memory();
    return bytes;
}

/// What shapes take that wait for their split, beside the list of their handles.
uint64_t waitingMemory(size_t count) {
    return listMemory(count, sizeof(PendingSplit));
}

/// The shapes that wait for their split, in a chunk of their own: saves of before have none.
std::vector<uint8_t> waitingToBytes(const WorldState& world, PaletteList& palettes, uint64_t& memory) {
    std::vector<ShapeHandle> waiting;
    for (const PendingSplit& pending : world.pendingSplits) waiting.push_back(pending.shape);
    std::vector<uint8_t> bytes;
    BinaryOutputArchive out(bytes, palettes);
    out.put(waiting);
    memory = out.memory() + waitingMemory(waiting.size());
    return bytes;
}

/// Scripts and what the host keeps, in a chunk of their own: most saves have none.
std::vector<uint8_t> hostDataToBytes(const WorldState& world, uint64_t& memory) {
    std::vector<uint8_t> bytes;
    PaletteList unused;
    BinaryOutputArchive out(bytes, unused);
    out.put(world.scripts);
    out.put(world.hostData);
    memory = out.memory();
    return bytes;
}

/// The generation of the slots that were never used, the same in all maps.
uint32_t firstGenerationOf(const WorldState& world) {
    return world.bodies.firstGeneration();
}

SavedGame stateFromBytes(ByteReader& reader, const std::vector<PaletteRef>& palettes, uint8_t number) {
    SavedGame game;
    BinaryInputArchive in(reader, palettes, number);
    WorldState& world = game.world;
    in.get(world.name);
    in.get(world.step), in.get(world.imported), in.get(world.removed);
    forEachKind(
        [&](auto& map) {
            if constexpr (!kIsJoints<decltype(map)>) getSlots(reader, in, number, map);
        },
        world);
    in.get(world.unsettled);
    in.get(world.materials.materials);
    in.get(world.environment);
    in.get(world.settings);
    in.get(world.bounds);
    in.get(world.footprint);
    in.get(world.made);
    in.get(world.locations);
    in.get(world.fire.fields);
    getSlots(reader, in, number, world.joints);
    world.fire.compact();
    in.get(game.pending);
    if (isPlanted("unsaved-field")) world.bodies.forEach([](BodyHandle, Body& body) { body.restingSince = 0; });
    return game;
}

/// Checks what a World takes for granted: every shape is on one body that lists it once, joints and heat name shapes
/// that exist, notes objects that exist, each once, ropes have points, each hot brick is listed once, inside its shape
/// and in order, and its heat is in range.
Result<Done> validateHandles(const WorldState& world) {
    std::string error;
    const auto fail = [&](const char* what, uint32_t slot) {
        if (error.empty())
            error = fmt::format("{} {}: expected handles of objects and bricks that exist, found others", what, slot);
    };
    size_t named = 0;
    world.bodies.forEach([&](BodyHandle handle, const Body& body) {
        for (const ShapeHandle shape : body.shapes) {
            const Shape* found = world.shapes.find(shape);
            if (!found || found->body != handle || std::count(body.shapes.begin(), body.shapes.end(), shape) != 1)
                fail("body", handle.slot());
        }
        named += body.shapes.size();
    });
    if (named != world.shapes.size()) fail("world", 0);
    world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        if (!world.bodies.find(shape.body)) fail("shape", handle.slot());
    });
    world.joints.forEach([&](JointHandle handle, const Joint& joint) {
        for (const JointEnd& end : joint.ends)
            if (end.shape && !world.shapes.find(end.shape)) fail("joint", handle.slot());
        const bool isRope = joint.kind == JointKind::Rope;
        if (joint.points.size() != (isRope ? joint.rope.points : 0) || (isRope && joint.points.empty()))
            fail("points of joint", handle.slot());
        std::string wrong = jointEndsError(joint);
        if (wrong.empty())
            wrong = jointBodiesError(joint.kind, world.shapes.find(joint.ends[0].shape),
                                     world.shapes.find(joint.ends[1].shape));
        if (error.empty() && !wrong.empty()) error = fmt::format("joint {}: {}", handle.slot(), wrong);
    });
    std::set<uint64_t> noted;
    world.notes.forEach([&](NoteHandle handle, const Note& note) {
        if (!isAlive(world, note.object) || !noted.insert(bitsOf(note.object)).second) fail("note", handle.slot());
    });
    std::set<ShapeHandle> waiting;
    for (const PendingSplit& pending : world.pendingSplits)
        if (!world.shapes.find(pending.shape) || !waiting.insert(pending.shape).second)
            fail("split of shape", pending.shape.slot());
    uint32_t next = 0;
    for (const HeatField& field : world.fire.fields) {
        const Shape* shape = world.shapes.find(field.shape);
        const auto isOutside = [&](const HotBrick& hot) {
            const glm::ivec3 size = shape->grid.sizeInBricks();
            return glm::any(glm::lessThan(hot.brick, glm::ivec3(0))) ||
                   glm::any(glm::greaterThanEqual(hot.brick, size));
        };
        const auto isNotBefore = [](const HotBrick& a, const HotBrick& b) { return !cellBefore(a.brick, b.brick); };
        if (!shape || field.shape.slot() < next || std::any_of(field.bricks.begin(), field.bricks.end(), isOutside) ||
            std::adjacent_find(field.bricks.begin(), field.bricks.end(), isNotBefore) != field.bricks.end())
            fail("heat of shape", field.shape.slot());
        for (const HotBrick& hot : field.bricks)
            if (error.empty() && (hot.heat < 0 || hot.heat > kMaxHeat || hot.charred > kCharRounds))
                error =
                    fmt::format("heat of shape {}: expected 0 to {} mJ and 0 to {} rounds of charring, found {} and {}",
                                field.shape.slot(), kMaxHeat, kCharRounds, hot.heat, hot.charred);
        next = field.shape.slot() + 1;
    }
    if (!error.empty()) return Error{error};
    return Done{};
}

/// What the chunks read so far have given.
struct ParsedSave {
    std::vector<PaletteRef> palettes;
    SavedGame game;
    std::vector<ShapeHandle> waiting;  ///< for their split
    std::vector<Shape*> shapes;
    std::vector<VoxelGrid*> grids;  ///< of all shapes, by the numbers that GRID chunks use
    uint32_t firstGeneration = 1;   ///< of slots that were never used
    std::vector<LevelScript> scripts;
    std::vector<HostData> hostData;
    bool haveState = false;
};

/// Reads the content of one chunk. Failures go to the reader of the file.
void readContent(const ChunkHeader& header, const std::vector<uint8_t>& raw, size_t chunk, uint8_t world,
                 ParsedSave& out, ByteReader& file) {
    const std::string kind(header.kind.data(), 4);
    ByteReader in(raw, fmt::format("of chunk {} of a save, unpacked", chunk), file);
    if (kind == "PALT") {
        out.palettes = palettesFromBytes(in);
    } else if (kind == "SAVE" && !out.haveState) {
        out.game = stateFromBytes(in, out.palettes, world);
        out.haveState = true;
        if (!in.failed())
            out.game.world.shapes.forEach(
                [&](ShapeHandle, Shape& shape) { out.shapes.push_back(&shape), out.grids.push_back(&shape.grid); });
    } else if (kind == "WAIT") {
        BinaryInputArchive(in, out.palettes, world).get(out.waiting);
        in.takeMemory(waitingMemory(out.waiting.size()));
    } else if (kind == "HOST") {
        BinaryInputArchive archive(in, out.palettes, world);
        archive.get(out.scripts);
        archive.get(out.hostData);
    } else if (kind == "GENS") {
        out.firstGeneration = in.read<uint32_t>();
    } else if (kind == "GRID") {
        readGridChunk(in, out.grids);
    } else if (kind == "LEVL") {
        return file.fail("a saved game", "a level, which load_level() reads");
    } else {
        return;
    }
    in.expectEnd("chunk");
    file.takeErrorOf(in);
}

/// Checks that a World's shapes have cells and that all numbers are within their ranges.
Result<Done> validateNumbers(const WorldState& world) {
    std::string error = settingsError(world.settings);
    if (!error.empty()) return Error{"settings: expected valid ones, found " + error};
    for (const WorldBox* box : {&world.footprint, &world.made}) {  // the bounds are the level's
        error = objectError(*box);
        if (!error.empty()) return Error{"footprint: expected a valid box, found " + error};
    }
    forEachKind(
        [&](const auto& map) {
            map.forEach([&](auto handle, const auto& object) {
                if (!error.empty()) return;
                error = objectError(object);
                if (!error.empty())
                    error = fmt::format("slot {}: expected valid numbers, found {}", handle.slot(), error);
            });
        },
        world);
    // One without voxels may wait for its split.
    world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        if (error.empty() && shape.grid.size() == glm::ivec3(0))
            error = fmt::format("shape {}: expected a grid of cells, found none", handle.slot());
    });
    if (!error.empty()) return Error{error};
    return Done{};
}

/// Checks that a World can be in this state and then has the hash that the file has.
Result<Done> validateState(const WorldState& state, uint8_t number, uint64_t hash) {
    if (Result<Done> checked = validateHandles(state); !checked) return checked;
    if (Result<Done> checked = validateNumbers(state); !checked) return checked;
    World world(number);
    world.setState(state);
    if (Result<Done> checked = validateLevel(toLevel(world)); !checked) return checked;
    if (world.hash() != hash)
        return Error{
            fmt::format("byte 16: expected the hash of the world, {:016x}, found {:016x}", world.hash(), hash)};
    return Done{};
}

}  // namespace

std::vector<uint8_t> gameToBytes(const SavedGame& game, uint64_t* memory) {
    World world;
    world.setState(game.world);
    world.resetCaches();
    return gameToBytes({world.state(), game.pending}, world.hash(), memory);
}

std::vector<uint8_t> gameToBytes(const SavedGame& game, uint64_t hash, uint64_t* memory) {
    ChunkWriter out;
    PaletteList palettes;
    uint64_t stateMemory = 0;
    const std::vector<uint8_t> state = stateToBytes(game, palettes, stateMemory);
    out.add({'P', 'A', 'L', 'T'}, palettesToBytes(palettes.palettes()));
    out.add({'S', 'A', 'V', 'E'}, state, stateMemory);
    if (!game.world.pendingSplits.empty()) {
        uint64_t listMemory = 0;
        const std::vector<uint8_t> waiting = waitingToBytes(game.world, palettes, listMemory);
        out.add({'W', 'A', 'I', 'T'}, waiting, listMemory);
    }
    if (const uint32_t first = firstGenerationOf(game.world); first != 1) {
        std::vector<uint8_t> generation(sizeof first);
        std::memcpy(generation.data(), &first, sizeof first);
        out.add({'G', 'E', 'N', 'S'}, generation);
    }
    if (!game.world.scripts.empty() || !game.world.hostData.empty()) {
        uint64_t dataMemory = 0;
        const std::vector<uint8_t> data = hostDataToBytes(game.world, dataMemory);
        out.add({'H', 'O', 'S', 'T'}, data, dataMemory);
    }
    GridChunkWriter grids(out);
    uint32_t shape = 0;
    game.world.shapes.forEach([&](ShapeHandle, const Shape& each) { grids.addGrid(shape++, each.grid); });
    std::vector<uint8_t> file = out.file(hash);
    if (memory) *memory = out.memory();
    return file;
}

Result<SavedGame> gameFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world) {
    ByteReader in(bytes, "save");
    return gameFrom(in, name, world);
}

Result<SavedGame> gameFrom(ByteReader& in, const std::string& name, uint8_t world) {
    ParsedSave parsed;
    const FileHeader header = readChunkFile(in, [&](const ChunkHeader& chunk, const std::vector<uint8_t>& raw,
                                                    uint32_t i) { readContent(chunk, raw, i, world, parsed, in); });
    if (!parsed.haveState) in.fail("a SAVE chunk", "none");
    if (in.failed()) return Error{name + ": " + in.error()};
    WorldState& state = parsed.game.world;
    state.scripts = std::move(parsed.scripts), state.hostData = std::move(parsed.hostData);
    forEachKind([&](auto& map) { map.setFirstGeneration(parsed.firstGeneration); }, state);
    state.pendingSplits.reserve(parsed.waiting.size());
    for (const ShapeHandle shape : parsed.waiting) state.pendingSplits.push_back({shape, {}, {}});
    for (Shape* shape : parsed.shapes) {
        if (!shape->palette) shape->palette = std::make_shared<const Palette>();
        shape->moments = gridMoments(shape->grid, *shape->palette, state.materials);
    }
    if (const Result<Done> checked = validateState(state, world, header.contentHash); !checked)
        return Error{name + ": " + checked.error()};
    restartPendingSplits(state);
    return std::move(parsed.game);
}

Result<Done> writeSave(const std::string& path, const SavedGame& game) {
    return writeFileAtomically(path, gameToBytes(game), kMaxFileBytes);
}

Result<SavedGame> readSave(const std::string& path, uint8_t world) {
    const Result<std::vector<uint8_t>> bytes = readFileBytes(path, kMaxFileBytes);
    if (!bytes) return Error{bytes.error()};
    try {
        return gameFromBytes(*bytes, path, world);
    } catch (const std::bad_alloc&) {
        return Error{path + ": not enough memory for what it describes"};
    }
}

}  // namespace rubble
