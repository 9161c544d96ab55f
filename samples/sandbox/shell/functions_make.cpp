#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/script/binding/calls.h"
#include "samples/sandbox/shell/fields.h"
#include "samples/sandbox/shell/functions.h"
#include "samples/sandbox/shell/game.h"

namespace sandbox {
namespace {

using namespace rubble::script;

/// Leaves the field of a table on the stack; its index.
int pushField(lua_State* L, int table, const char* name) {
    lua_getfield(L, table, name);
    return lua_gettop(L);
}

double fieldOr(lua_State* L, int table, const char* name, double low, double high, double otherwise) {
    const int at = pushField(L, table, name);
    const double value = lua_isnil(L, at) ? otherwise : rangedAt(L, at, name, low, high);
    lua_pop(L, 1);
    return value;
}

int elementAt(lua_State* L, int table, int place, const char* name, int low, int high) {
    lua_geti(L, table, place);
    const int value = wholeAt(L, lua_gettop(L), name, low, high);
    lua_pop(L, 1);
    return value;
}

/// The same of a place, which may lie inside of a cell.
double placeAt(lua_State* L, int table, int place, const char* name, double low, double high) {
    lua_geti(L, table, place);
    const double value = rangedAt(L, lua_gettop(L), name, low, high);
    lua_pop(L, 1);
    return value;
}

uint8_t byteOf(double share) {
    return uint8_t(std::clamp(share * 255.0 + 0.5, 0.0, 255.0));
}

/// A material of the world by its name; "none": it is seen, and touches nothing.
uint8_t materialOf(lua_State* L, int row) {
    const std::string name = textOr(L, pushField(L, row, "material"), "material", "none");
    lua_pop(L, 1);
    uint32_t index = 0;
    if (name == "none") return 0;
    if (apiOf(L).find_material(worldOf(L), name.c_str(), &index) != RUBBLE_OK || index == 0)
        luaL_error(L, "CreateModel: expected a material of the world, found \"%s\"", name.c_str());
    return uint8_t(index);
}

/// Refuses a value that is no list of at most so many elements; its length.
int lengthAt(lua_State* L, int index, const char* name, int most) {
    requireTable(L, index, name);
    const lua_Unsigned length = lua_rawlen(L, index);
    if (length > lua_Unsigned(most))
        refuseArgument(L, index, name, ("a list of at most " + std::to_string(most)).c_str());
    requireKeys(L, index, name, {}, lua_Integer(length));
    return int(length);
}

/// Colours {r, g, b} of 0 to 1 with roughness, metallic, emission, opacity and material. There may be none.
std::vector<rubble_palette_entry> paletteAt(lua_State* L, int table) {
    static constexpr const char* kKeys[] = {"material", "roughness", "metallic", "emission", "opacity"};
    std::vector<rubble_palette_entry> entries;
    if (lua_isnil(L, table)) return entries;
    const int count = lengthAt(L, table, "palette", 255);
    for (int i = 1; i <= count; ++i) {
        lua_geti(L, table, i);
        const int row = lua_gettop(L);
        requireKeys(L, row, "palette", kKeys, 3);
        rubble_palette_entry entry = {};
        for (int k = 0; k < 3; ++k) {
            lua_geti(L, row, k + 1);
            entry.color[k] = byteOf(rangedAt(L, lua_gettop(L), "palette", 0.0, 1.0));
            lua_pop(L, 1);
        }
        entry.opacity = byteOf(fieldOr(L, row, "opacity", 0.0, 1.0, 1.0));
        entry.roughness = byteOf(fieldOr(L, row, "roughness", 0.0, 1.0, 0.6));
        entry.metallic = byteOf(fieldOr(L, row, "metallic", 0.0, 1.0, 0.0));
        entry.reflectivity = 10;
        entry.emission = fieldOr(L, row, "emission", 0.0, 1e6, 0.0);
        entry.material = materialOf(L, row);
        entries.push_back(entry);
        lua_pop(L, 1);
    }
    return entries;
}

/// One of so many entries for a cell: the same in clumps, as paint is worn.
int shadeOf(int x, int y, int z, int shades) {
    const auto hash = [](uint32_t a, uint32_t b, uint32_t c) {
        uint32_t value = a * 73856093u ^ b * 19349663u ^ c * 83492791u;
        value = (value ^ value >> 15) * 2246822519u;
        return value ^ value >> 13;
    };
    const uint32_t clump = hash(uint32_t(x) / 3, uint32_t(y) / 2, uint32_t(z) / 3);
    return int((clump % 3 ? clump / 3 : hash(uint32_t(x), uint32_t(y), uint32_t(z))) % uint32_t(shades));
}

/// Boxes {x, y, z, x1, y1, z1, entry, shades} in cells, both corners in; what is outside of the grid is left out.
/// Shades: how many entries from that one on vary from cell to cell; without it one.
std::vector<uint8_t> fillBoxes(lua_State* L, int table, const std::array<int, 3>& size) {
    std::vector<uint8_t> cells(size_t(size[0]) * size_t(size[1]) * size_t(size[2]), 0);
    Sandbox::of(L).charge(L, int64_t(cells.size() / 8));
    const int count = lengthAt(L, table, "boxes", 1 << 20);
    for (int i = 1; i <= count; ++i) {
        lua_geti(L, table, i);
        const int row = lua_gettop(L);
        requireKeys(L, row, "boxes", {}, 8);
        std::array<int, 6> box;
        for (int k = 0; k < 6; ++k) box[size_t(k)] = elementAt(L, row, k + 1, "boxes", -4096, 4096);
        const auto entry = uint8_t(elementAt(L, row, 7, "boxes", 0, 255));
        const int shades = lua_geti(L, row, 8) == LUA_TNIL ? 1 : elementAt(L, row, 8, "boxes", 1, 16);
        lua_pop(L, 2);
        for (int z = std::max(box[2], 0); z <= std::min(box[5], size[2] - 1); ++z)
            for (int y = std::max(box[1], 0); y <= std::min(box[4], size[1] - 1); ++y)
                for (int x = std::max(box[0], 0); x <= std::min(box[3], size[0] - 1); ++x)
                    cells[(size_t(z) * size_t(size[1]) + size_t(y)) * size_t(size[0]) + size_t(x)] =
                        uint8_t(std::min(255, entry + shadeOf(x, y, z, shades)));
    }
    return cells;
}

/// The grid {number, place} of a file that was dropped; null: the model has boxes.
const DropGrid* gridAt(lua_State* L, int table) {
    if (lua_isnil(L, table)) return nullptr;
    requireKeys(L, table, "grid", {}, 2);
    const std::vector<Drop>& all = gameOf(L).drops().all();
    const Drop& drop = all[size_t(elementAt(L, table, 1, "grid", 1, int(all.size()))) - 1];
    return &drop.grids[size_t(elementAt(L, table, 2, "grid", 1, int(drop.grids.size()))) - 1];
}

int createModel(lua_State* L) {
    static constexpr const char* kKeys[] = {"size", "voxel", "origin", "palette", "boxes", "muzzle", "grid"};
    requireKeys(L, 1, "model", kKeys);
    const Placement place = placementAt(L, 2, "transform");
    const double voxel = fieldOr(L, 1, "voxel", 0.005, 1.0, 0.1);
    std::array<int, 3> size;
    const int sizeAt = pushField(L, 1, "size");
    requireKeys(L, sizeAt, "size", {}, 3);
    const DropGrid* const dropped = gridAt(L, pushField(L, 1, "grid"));
    for (int i = 0; i < 3; ++i)
        size[size_t(i)] = dropped ? dropped->size[size_t(i)] : elementAt(L, sizeAt, i + 1, "size", 1, 128);
    std::vector<uint8_t> filled;
    if (!dropped) filled = fillBoxes(L, pushField(L, 1, "boxes"), size);
    const std::vector<uint8_t>& cells = dropped ? dropped->cells : filled;
    if (dropped) Sandbox::of(L).charge(L, int64_t(cells.size() / 64));
    const std::vector<rubble_palette_entry> palette = paletteAt(L, pushField(L, 1, "palette"));
    const int origin = pushField(L, 1, "origin");  // the cell that is at the body's frame
    const bool hasOrigin = !lua_isnil(L, origin);
    if (hasOrigin) requireKeys(L, origin, "origin", {}, 3);
    std::array<double, 3> at;
    for (int i = 0; i < 3; ++i)
        at[size_t(i)] = hasOrigin ? placeAt(L, origin, i + 1, "origin", -4096.0, 4096.0) : 0.5 * size[size_t(i)];

    auto body = sized<rubble_body_settings>();
    body.flags = boolOr(L, 3, false) ? 0u : uint32_t(RUBBLE_BODY_STATIC);
    copy(body.position, place.position);
    copy(body.rotation, place.rotation);
    rubble_body made = 0;
    if (!isDone(L, apiOf(L).create_body(worldOf(L), &body, &made))) return 0;
    auto shape = sized<rubble_shape_settings>();
    shape.source = RUBBLE_SHAPE_INDICES;
    shape.body = made;
    shape.rotation[3] = 1.0;
    shape.voxel_size = voxel;
    for (int i = 0; i < 3; ++i) {
        shape.position[i] = -voxel * at[size_t(i)];
        shape.size[i] = size[size_t(i)];
    }
    shape.indices = cells.data(), shape.count = cells.size();
    rubble_shape grid = 0;
    if (!isDone(L, apiOf(L).create_shape(worldOf(L), &shape, &grid))) return 0;
    if (!palette.empty()) {
        auto range = sized<rubble_palette_range>();
        range.shape = grid;
        range.first = 1, range.count = uint32_t(palette.size()), range.entry_size = sizeof(rubble_palette_entry);
        isDone(L, apiOf(L).set_palette(worldOf(L), &range, palette.data()));
    }
    auto& created = ScriptContext::of(L).shared.pending.created;
    created[made] = RUBBLE_KIND_BODY;
    created[grid] = RUBBLE_KIND_SHAPE;
    pushHandle(L, made);
    pushHandle(L, grid);
    return 2;
}

int createRope(lua_State* L) {
    auto rope = sized<rubble_joint_settings>();
    rope.kind = RUBBLE_JOINT_ROPE;
    rope.rotation[3] = 1.0;
    rope.shapes[0] = handleAt(L, 1, "shapeA");
    copy(rope.position, vectorAt(L, 2, "posA"));
    rope.shapes[1] = handleAt(L, 3, "shapeB");
    copy(rope.rope_end, vectorAt(L, 4, "posB"));
    rope.rope_length = numberOr(L, 5, "length", 0.0);
    rope.rope_strength = numberOr(L, 6, "strength", 0.0);
    return pushJoint(L, rope);
}

int createNail(lua_State* L) {
    auto nail = sized<rubble_joint_settings>();
    nail.kind = RUBBLE_JOINT_FIXED;
    nail.rotation[3] = 1.0;
    nail.shapes[0] = handleAt(L, 1, "shapeA");
    nail.shapes[1] = handleAt(L, 2, "shapeB");
    copy(nail.position, vectorAt(L, 3, "pos"));
    nail.break_force = numberOr(L, 4, "strength", 0.0);
    return pushJoint(L, nail);
}

constexpr ScriptFunction kFunctions[] = {
    {"CreateModel(model, transform, dynamic) -> body, shape",
     "A body of boxes {x, y, z, x1, y1, z1, entry, shades}: size, voxel (m), origin (cells), palette, boxes, or grid.",
     createModel, 0, "position transform, rotation transform, voxel_size voxel"},
    {"CreateRope(shapeA, posA, shapeB, posB, length, strength) -> joint",
     "A rope; length 0: as long as it is, strength 0: it never breaks.", createRope, 0,
     "position posA, rope_end posB, rope_length length, rope_strength strength"},
    {"CreateNail(shapeA, shapeB, pos, strength) -> joint", "Holds two shapes together at a place.", createNail, 0,
     "break_force strength"},
};

}  // namespace

std::span<const ScriptFunction> makeFunctions() {
    return kFunctions;
}

}  // namespace sandbox
