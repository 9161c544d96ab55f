#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

/// The state of the shape of argument 1; false: it is gone.
bool readShape(lua_State* L, rubble_shape_state& state) {
    state = {};
    state.rotation[3] = 1.0;
    return isDone(L, apiOf(L).get_shape_state(worldOf(L), handleAt(L, 1, "shape"), &state));
}

/// The properties of the shape of argument 1; false: it is gone.
bool readProperties(lua_State* L, rubble_shape_properties& properties) {
    return isDone(L, apiOf(L).get_shape_properties(worldOf(L), handleAt(L, 1, "shape"), &properties));
}

rubble_shape_properties propertiesAt(lua_State* L) {
    auto properties = sized<rubble_shape_properties>();
    readProperties(L, properties);
    return properties;
}

int getBody(lua_State* L) {
    rubble_shape_state state;
    readShape(L, state);
    pushHandle(L, state.body);
    return 1;
}

int getWorldTransform(lua_State* L) {
    rubble_shape_state state;
    readShape(L, state);
    pushPlacement(L, placementOf(state.position, state.rotation));
    return 1;
}

int getLocalTransform(lua_State* L) {
    rubble_shape_state state;
    rubble_body_state body = {};
    body.rotation[3] = 1.0;
    if (readShape(L, state)) isDone(L, apiOf(L).get_body_state(worldOf(L), state.body, &body));
    const Placement frame = placementOf(body.position, body.rotation);
    const Placement own = placementOf(state.position, state.rotation);
    pushPlacement(L, {toLocal(frame, own.position), inverse(frame.rotation) * own.rotation});
    return 1;
}

int getBounds(lua_State* L) {
    return pushBounds(L, {handleAt(L, 1, "shape")});
}

template <uint32_t Kind>
int getOwned(lua_State* L) {
    rubble_shape_state state;
    if (!readShape(L, state)) return pushHandles(L, nullptr, 0);
    const std::vector<uint64_t>& owned = readOwned(L, state.shape, Kind);
    return pushHandles(L, owned.data(), owned.size());
}

int getSize(lua_State* L) {
    rubble_shape_state state;
    readShape(L, state);
    for (const int32_t cells : state.size) lua_pushinteger(L, cells);
    lua_pushnumber(L, state.voxel_size);
    return 4;
}

int getVoxelCount(lua_State* L) {
    rubble_shape_state state;
    readShape(L, state);
    lua_pushinteger(L, lua_Integer(state.voxel_count));
    return 1;
}

/// Pushes material, r, g, b, a and the entry of a palette; of entry 0 what is empty.
int pushEntry(lua_State* L, rubble_shape shape, uint32_t index) {
    rubble_palette_entry entry = {};
    auto range = sized<rubble_palette_range>();
    range.shape = shape;
    range.first = index;
    range.count = 1;
    range.entry_size = sizeof entry;
    auto material = sized<rubble_material>();
    const bool isThere = index && isDone(L, apiOf(L).get_palette(worldOf(L), &range, &entry));
    if (isThere && entry.material) isDone(L, apiOf(L).get_material(worldOf(L), entry.material, &material));
    lua_pushstring(L, material.name ? material.name : "");
    for (const uint8_t channel : entry.color) lua_pushnumber(L, channel / 255.0);
    lua_pushnumber(L, entry.opacity / 255.0);
    lua_pushinteger(L, isThere ? index : 0);
    return 6;
}

int pushCell(lua_State* L, rubble_shape shape, const std::array<int32_t, 3>& cell) {
    auto box = sized<rubble_voxel_box>();
    box.shape = shape;
    std::copy(cell.begin(), cell.end(), box.low);
    std::fill_n(box.size, 3, 1);
    uint8_t index = 0;
    uint64_t count = 0;
    isDone(L, apiOf(L).read_voxels(worldOf(L), &box, &index, 1, &count));
    return pushEntry(L, shape, index);
}

int32_t cellOf(double place) {
    return int32_t(std::clamp(std::floor(place), -4096.0, 4096.0));
}

int getMaterialAtPosition(lua_State* L) {
    const Vector position = vectorAt(L, 2, "pos");
    if (!std::isfinite(length(position))) refuseArgument(L, 2, "pos", "three finite numbers");
    rubble_shape_state state;
    if (!readShape(L, state)) return pushEntry(L, 0, 0);
    const Vector local = toLocal(placementOf(state.position, state.rotation), position) * (1.0 / state.voxel_size);
    return pushCell(L, state.shape, {cellOf(local[0]), cellOf(local[1]), cellOf(local[2])});
}

int getMaterialAtIndex(lua_State* L) {
    const std::array<int32_t, 3> cell{cellOf(clampedAt(L, 2, "x", -4096.0, 4096.0)),
                                      cellOf(clampedAt(L, 3, "y", -4096.0, 4096.0)),
                                      cellOf(clampedAt(L, 4, "z", -4096.0, 4096.0))};
    return pushCell(L, handleAt(L, 1, "shape"), cell);
}

int getMaterial(lua_State* L) {
    const double entry = numberAt(L, 2, "entry");
    if (!(entry >= 0.0 && entry <= 255.0)) refuseArgument(L, 2, "entry", "0 to 255");
    return pushEntry(L, handleAt(L, 1, "shape"), uint32_t(entry));
}

/// Sets one number of a shape. field: its RUBBLE_SHAPE_ flag.
int setNumber(lua_State* L, uint32_t field, double rubble_shape_change::*number, const char* name) {
    auto change = sized<rubble_shape_change>();
    change.fields = field;
    change.shape = handleAt(L, 1, "shape");
    change.*number = numberAt(L, 2, name);
    isDone(L, apiOf(L).set_shape(worldOf(L), &change));
    return 0;
}

int setDensity(lua_State* L) {
    return setNumber(L, RUBBLE_SHAPE_DENSITY, &rubble_shape_change::density, "density");
}

int setEmissiveScale(lua_State* L) {
    return setNumber(L, RUBBLE_SHAPE_EMISSION, &rubble_shape_change::emission, "scale");
}

int getCollisionFilter(lua_State* L) {
    const rubble_shape_properties properties = propertiesAt(L);
    lua_pushinteger(L, properties.collision_layer);
    lua_pushinteger(L, properties.collision_mask);
    return 2;
}

uint32_t bitsAt(lua_State* L, int index, const char* name) {
    const double bits = numberAt(L, index, name);
    if (!(bits >= 0.0 && bits <= 255.0)) refuseArgument(L, index, name, "8 bits, 0 to 255");
    return bits >= 1.0 ? uint32_t(bits) : uint32_t(RUBBLE_COLLISION_NONE);
}

int setCollisionFilter(lua_State* L) {
    auto filter = sized<rubble_collision_filter>();
    filter.shape = handleAt(L, 1, "shape");
    filter.layer = bitsAt(L, 2, "layer");
    filter.mask = bitsAt(L, 3, "mask");
    isDone(L, apiOf(L).set_collision_filter(worldOf(L), &filter));
    return 0;
}

int isBroken(lua_State* L) {
    auto properties = sized<rubble_shape_properties>();
    const bool isMade = isMadeInThisStep(L, handleAt(L, 1, "shape"));
    lua_pushboolean(L, !isMade && (!readProperties(L, properties) || properties.is_broken));
    return 1;
}

/// Whether the body of a shape is static; false: one of the two is gone.
bool isHeld(lua_State* L, bool& held) {
    rubble_shape_state state;
    rubble_body_state body = {};
    if (!readShape(L, state) || !isDone(L, apiOf(L).get_body_state(worldOf(L), state.body, &body))) return false;
    held = body.flags & RUBBLE_BODY_STATIC;
    return true;
}

int isDisconnected(lua_State* L) {
    bool held = false;
    lua_pushboolean(L, isHeld(L, held) && !held);
    return 1;
}

int isStaticDetached(lua_State* L) {
    bool held = false;
    const bool isThere = isHeld(L, held);
    lua_pushboolean(L, isThere && !held && propertiesAt(L).is_piece);
    return 1;
}

int getClosestPoint(lua_State* L) {
    const Vector origin = vectorAt(L, 2, "origin");
    rubble_shape_state state;
    rubble_hit hit = {};
    std::vector<rubble_shape> nearer;  // shapes that lie before it: a query of one shape alone the interface has not
    auto filter = sized<rubble_query_filter>();
    if (readShape(L, state)) {
        do {
            if (hit.shape) nearer.push_back(hit.shape);
            filter.rejected_shapes = nearer.data();
            filter.rejected_shape_count = uint32_t(nearer.size());
            Sandbox::of(L).charge(L, 200);
            isDone(L, apiOf(L).find_closest_point(worldOf(L), origin.data(), 1000.0, &filter, &hit));
        } while (hit.shape && hit.shape != state.shape);
    }
    lua_pushboolean(L, hit.shape != 0);
    pushVector(L, hit.position);
    pushVector(L, hit.normal);
    return 3;
}

/// Whether voxels of one shape lie within half a voxel of the other's.
int isTouching(lua_State* L) {
    rubble_shape_state state;
    const rubble_shape other = handleAt(L, 2, "other");
    bool touches = false;
    uint32_t count = 0;
    if (readShape(L, state) && isDone(L, apiOf(L).get_body_boxes(worldOf(L), state.body, nullptr, 0, &count))) {
        std::vector<rubble_body_box> boxes(count);
        rubble_body_state body = {};
        isDone(L, apiOf(L).get_body_boxes(worldOf(L), state.body, boxes.data(), count, &count));
        isDone(L, apiOf(L).get_body_state(worldOf(L), state.body, &body));
        const Placement frame = placementOf(body.position, body.rotation);
        for (const rubble_body_box& box : boxes) {
            if (touches) break;
            if (box.shape != state.shape) continue;
            rubble_query_shape region = {};
            region.kind = RUBBLE_QUERY_BOX;
            copy(region.position, toParent(frame, vectorOf(box.center)));
            copy(region.rotation, frame.rotation * placementOf(box.center, box.rotation).rotation);
            for (int i = 0; i < 3; ++i) region.half_size[i] = box.half_size[i] + 0.5 * state.voxel_size;
            const auto& found = readHandles(L, [&](uint64_t* out, uint32_t capacity, uint32_t* total) {
                return apiOf(L).overlap_shapes(worldOf(L), &region, nullptr, out, capacity, total);
            });
            touches = std::find(found.begin(), found.end(), other) != found.end();
            Sandbox::of(L).charge(L, 100);
        }
    }
    lua_pushboolean(L, touches);
    return 1;
}

constexpr ScriptFunction kFunctions[] = {
    {"GetShapeBody(shape) -> body", "The body that it is on.", getBody},
    {"GetShapeWorldTransform(shape) -> transform", "The minimum corner of its grid and its axes, in the world.",
     getWorldTransform},
    {"GetShapeLocalTransform(shape) -> transform", "The same in the frame of its body.", getLocalTransform},
    {"GetShapeBounds(shape) -> min, max", "The box around its grid, in the world.", getBounds},
    {"GetShapeJoints(shape) -> list", "The joints that hold it.", getOwned<RUBBLE_KIND_JOINT>},
    {"GetShapeLights(shape) -> list", "The lights on it.", getOwned<RUBBLE_KIND_LIGHT>},
    {"GetShapeSize(shape) -> x, y, z, scale", "The cells of its grid, and metres of one.", getSize},
    {"GetShapeVoxelCount(shape) -> count", "How many of them hold a voxel.", getVoxelCount},
    {"GetShapeMaterialAtPosition(shape, pos) -> type, r, g, b, a, entry",
     "What is at a place of the world; \"\" and 0 if nothing is.", getMaterialAtPosition},
    {"GetShapeMaterialAtIndex(shape, x, y, z) -> type, r, g, b, a, entry", "What is in a cell of its grid.",
     getMaterialAtIndex},
    {"GetShapeMaterial(shape, entry) -> type, r, g, b, a, entry", "An entry of its palette.", getMaterial},
    {"SetShapeEmissiveScale(shape, scale)", "Multiplies what its voxels glow with.", setEmissiveScale, 50},
    {"SetShapeDensity(shape, density)", "Multiplies the density of its materials.", setDensity, 200},
    {"GetShapeCollisionFilter(shape) -> layer, mask", "Bits of collision layers.", getCollisionFilter},
    {"SetShapeCollisionFilter(shape, layer, mask)",
     "Two shapes collide if the layer of each is in the mask of the other.", setCollisionFilter, 50},
    {"IsShapeBroken(shape) -> boolean",
     "Whether it has lost voxels, or is gone; saved games keep that, levels do not, and an undo takes it back.",
     isBroken},
    {"IsShapeDisconnected(shape) -> boolean", "Whether it moves freely.", isDisconnected},
    {"IsStaticShapeDetached(shape) -> boolean", "Whether it came off another shape and moves freely.",
     isStaticDetached},
    {"IsShapeTouching(shape, other) -> boolean", "Whether voxels of two shapes are within half a voxel of each other.",
     isTouching},
    {"GetShapeClosestPoint(shape, origin) -> hit, pos, normal", "Its point that is the closest to a place.",
     getClosestPoint},
};

}  // namespace

std::span<const ScriptFunction> shapeFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
