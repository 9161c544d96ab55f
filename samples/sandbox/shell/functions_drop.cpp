// Files that were dropped on the window.
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

constexpr int kThumbCells = 44;  ///< of the longest side of a small image
constexpr int64_t kReadWork = 100'000, kObjectWork = 500, kObjectStepWork = 2000;  ///< as of Spawn()

const Drop& dropAt(lua_State* L) {
    const std::vector<Drop>& all = gameOf(L).drops().all();
    return all[size_t(wholeAt(L, 1, "number", 1, int(all.size()))) - 1];
}

void setText(lua_State* L, const char* name, const std::string& text) {
    lua_pushlstring(L, text.data(), text.size());
    lua_setfield(L, -2, name);
}

void setNumber(lua_State* L, const char* name, double value) {
    lua_pushnumber(L, value);
    lua_setfield(L, -2, name);
}

template <class List>
void setList(lua_State* L, const char* name, const List& list) {
    lua_createtable(L, int(list.size()), 0);
    for (size_t i = 0; i < list.size(); ++i) {
        lua_pushnumber(L, double(list[i]));
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    lua_setfield(L, -2, name);
}

void pushPalette(lua_State* L, const std::vector<rubble_palette_entry>& palette) {
    lua_createtable(L, int(palette.size()), 0);
    for (size_t i = 0; i < palette.size(); ++i) {
        lua_createtable(L, 3, 1);
        for (int k = 0; k < 3; ++k) {
            lua_pushnumber(L, palette[i].color[k] / 255.0);
            lua_rawseti(L, -2, k + 1);
        }
        setNumber(L, "emission", palette[i].emission);
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
}

/// Rows of equal cells along x.
void setBoxes(lua_State* L, const DropGrid& grid) {
    lua_newtable(L);
    lua_Integer count = 0;
    const uint8_t* row = grid.cells.data();
    for (int z = 0; z < grid.size[2]; ++z)
        for (int y = 0; y < grid.size[1]; ++y, row += grid.size[0])
            for (int x = 0, end = 0; x < grid.size[0]; x = end) {
                for (end = x; end < grid.size[0] && row[end] == row[x];) ++end;
                if (row[x] == 0) continue;
                const int values[] = {x, y, z, end - 1, y, z, row[x]};
                lua_createtable(L, 7, 0);
                for (int k = 0; k < 7; ++k) {
                    lua_pushinteger(L, values[k]);
                    lua_rawseti(L, -2, k + 1);
                }
                lua_rawseti(L, -2, ++count);
            }
    Sandbox::of(L).charge(L, 10 * count);
    lua_setfield(L, -2, "boxes");
}

/// A piece {model =, at =, rot =}; the palette lies below it.
void pushPiece(lua_State* L, const DropGrid& grid, int palette) {
    lua_createtable(L, 0, 3);
    pushVector(L, grid.position.data());
    lua_setfield(L, -2, "at");
    pushRotation(L, grid.rotation.data());
    lua_setfield(L, -2, "rot");
    lua_createtable(L, 0, 5);
    setList(L, "size", grid.size);
    setList(L, "origin", std::vector<int>(3, 0));
    setNumber(L, "voxel", grid.voxel);
    lua_pushvalue(L, palette);
    lua_setfield(L, -2, "palette");
}

int getDropCount(lua_State* L) {
    lua_pushinteger(L, lua_Integer(gameOf(L).drops().all().size()));
    return 1;
}

int getDrop(lua_State* L) {
    const Drop& drop = dropAt(L);
    lua_newtable(L);
    setText(L, "path", drop.path);
    setText(L, "name", drop.name);
    if (!drop.error.empty()) setText(L, "error", drop.error);
    if (!drop.script.empty()) setText(L, "script", drop.script);
    lua_pushboolean(L, drop.isFree);
    lua_setfield(L, -2, "isFree");
    pushPalette(L, drop.palette);
    const int palette = lua_gettop(L);
    lua_newtable(L);
    for (size_t i = 0; i < drop.grids.size(); ++i) {
        pushPiece(L, drop.grids[i], palette);
        setList(L, "grid", std::vector<lua_Integer>{lua_tointeger(L, 1), lua_Integer(i) + 1});
        lua_setfield(L, -2, "model");
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    lua_setfield(L, palette - 1, "pieces");
    lua_settop(L, palette - 1);
    return 1;
}

int getDropImage(lua_State* L) {
    const Drop& drop = dropAt(L);
    double longest = 0.0;
    for (const DropGrid& grid : drop.grids)
        for (const int side : grid.size) longest = std::max(longest, side * grid.voxel);
    pushPalette(L, drop.palette);
    const int palette = lua_gettop(L);
    lua_newtable(L);
    lua_Integer count = 0;
    for (const DropGrid& grid : drop.grids) {
        const DropGrid small = coarser(grid, std::max(1, int(std::ceil(longest / grid.voxel / kThumbCells))));
        pushPiece(L, small, palette);
        setBoxes(L, small);
        lua_setfield(L, -2, "model");
        lua_rawseti(L, -2, ++count);
    }
    return 1;
}

int placeDrop(lua_State* L) {
    const Drop& drop = dropAt(L);
    const Placement place = finitePlacementAt(L, 2, "transform");
    auto prefab = sized<rubble_prefab>();
    prefab.path = drop.path.c_str();
    prefab.vdb_tool = gameOf(L).settings().vdbTool.c_str();
    copy(prefab.position, place.position);
    copy(prefab.rotation, place.rotation);
    Sandbox::of(L).charge(L, kReadWork);
    uint32_t count = 0;
    const bool isRead = apiOf(L).create_prefab(worldOf(L), &prefab, nullptr, 0, &count) == RUBBLE_OK;
    std::vector<rubble_prefab_row> rows(count);
    chargeStep(L, kObjectStepWork * count);
    Sandbox::of(L).charge(L, kObjectWork * count);
    if (!isRead || apiOf(L).create_prefab(worldOf(L), &prefab, rows.data(), count, &count) != RUBBLE_OK) {
        lua_pushnil(L);
        lua_pushstring(L, apiOf(L).get_last_error());
        return 2;
    }
    static constexpr uint32_t kKinds[] = {RUBBLE_KIND_BODY, RUBBLE_KIND_SHAPE, RUBBLE_KIND_JOINT, RUBBLE_KIND_LIGHT};
    std::vector<uint64_t> bodies;
    for (const rubble_prefab_row& row : rows) {
        ScriptContext::of(L).shared.pending.created[row.handle] = kKinds[row.kind];
        if (kKinds[row.kind] == RUBBLE_KIND_BODY) bodies.push_back(row.handle);
    }
    return pushHandles(L, bodies.data(), bodies.size());
}

int dropFile(lua_State* L) {
    if (gameOf(L).settings().bot.empty()) return luaL_error(L, "DropFile: expected a bot that plays, found none");
    gameOf(L).drops().add(textAt(L, 1, "path"));
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"GetDropCount() -> number", "How many files were dropped on the window.", getDropCount},
    {"GetDrop(number) -> drop", "One of them: path, name; error, or script, or pieces and isFree.", getDrop},
    {"GetDropImage(number) -> pieces", "Its pieces in few cells, for a small image.", getDropImage},
    {"PlaceDrop(number, transform) -> bodies", "Places a model or level that was dropped; nil and why it cannot.",
     placeDrop, 0, "position transform, rotation transform"},
    {"DropFile(path)", "As if it were dropped: for bots.", dropFile},
};

}  // namespace

std::span<const ScriptFunction> dropFunctions() {
    return kFunctions;
}

}  // namespace sandbox
