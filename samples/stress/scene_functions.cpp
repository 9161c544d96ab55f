#include "samples/stress/scene_functions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <string_view>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"
#include "samples/stress/scene_cuts.h"
#include "samples/support/material_colors.h"

namespace stress {
namespace {

using namespace rubble::script;

/// What is not the name of an option would test something else without a word.
void checkOptions(lua_State* L, int index, std::initializer_list<std::string_view> names) {
    if (lua_isnoneornil(L, index)) return;
    if (!lua_istable(L, index)) refuseArgument(L, index, "options", "a table");
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
        const char* const found = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
        if (std::find(names.begin(), names.end(), found) != names.end()) continue;
        std::string text;
        for (const std::string_view each : names) text.append(text.empty() ? "" : ", ").append(each);
        luaL_error(L, "%s: options: expected %s, found \"%s\"", runningFunction(L).name().c_str(), text.c_str(), found);
    }
}

/// A value of an argument, which must be a whole number.
double wholeIn(lua_State* L, int index, const char* name, double value, double low, double high) {
    if (value >= low && value <= high && value == std::floor(value)) return value;
    const std::string expected = fmt::format("whole numbers from {} to {}", low, high);
    refuseArgument(L, index, name, expected.c_str());
}

/// A field of the table of options at an index of the stack, which may be left out.
double optionNumber(lua_State* L, int index, const char* name, double otherwise) {
    if (!lua_istable(L, index)) return otherwise;
    lua_pushstring(L, name);
    lua_rawget(L, index);
    const double value = numberOr(L, lua_gettop(L), name, otherwise);
    lua_pop(L, 1);
    return value;
}
bool optionFlag(lua_State* L, int index, const char* name) {
    if (!lua_istable(L, index)) return false;
    lua_pushstring(L, name);
    lua_rawget(L, index);
    const bool value = lua_toboolean(L, -1);
    lua_pop(L, 1);
    return value;
}
Vector optionVector(lua_State* L, int index, const char* name, const Vector& otherwise) {
    if (!lua_istable(L, index)) return otherwise;
    lua_pushstring(L, name);
    lua_rawget(L, index);
    const Vector value = lua_isnil(L, -1) ? otherwise : vectorAt(L, lua_gettop(L), name);
    lua_pop(L, 1);
    return value;
}

/// Makes an object's handle known to the functions that come before the step.
uint64_t made(lua_State* L, uint64_t handle, uint32_t kind) {
    ScriptContext::of(L).shared.pending.created[handle] = kind;
    return handle;
}

/// The rotation that turns x to an axis.
Rotation axisRotation(const Vector& axis) {
    const Vector to = normalized(axis), from{1.0, 0.0, 0.0};
    const double along = dot(from, to);
    if (along > 0.999999) return {0.0, 0.0, 0.0, 1.0};
    if (along < -0.999999) return {0.0, 0.0, 1.0, 0.0};
    return aboutAxis(normalized(cross(from, to)), std::acos(std::clamp(along, -1.0, 1.0)));
}

/// The body of Box() and Ball(), as their options say.
rubble_body makeBody(lua_State* L, const Vector& position, int options) {
    auto body = sized<rubble_body_settings>();
    copy(body.position, position);
    body.rotation[3] = 1.0;
    if (optionFlag(L, options, "dynamic")) {
        copy(body.velocity, optionVector(L, options, "velocity", {}));
        copy(body.angular_velocity, optionVector(L, options, "spin", {}));
        if (optionFlag(L, options, "asleep")) body.flags = RUBBLE_BODY_ASLEEP;
    } else
        body.flags = RUBBLE_BODY_STATIC;
    const Vector turned = optionVector(L, options, "turned", {});  // radians about x, y, z
    const Rotation rotation =
        aboutAxis({0, 1, 0}, turned[1]) * aboutAxis({1, 0, 0}, turned[0]) * aboutAxis({0, 0, 1}, turned[2]);
    copy(body.rotation, rotation);
    rubble_body out = 0;
    isDone(L, apiOf(L).create_body(worldOf(L), &body, &out));
    return made(L, out, RUBBLE_KIND_BODY);
}

/// New palettes are white: gives the entry of a shape the colour of its material.
void tint(lua_State* L, rubble_shape shape, uint32_t index) {
    for (const rubble::MaterialColor& row : rubble::kMaterialColors) {
        if (row.entry != index) continue;
        auto range = sized<rubble_palette_range>();
        range.shape = shape, range.first = index, range.count = 1;
        rubble_palette_entry entry = {};
        std::copy_n(row.rgb, 3, entry.color);
        entry.opacity = row.opacity, entry.roughness = 200, entry.material = uint8_t(index == 15 ? 1 : index);
        isDone(L, apiOf(L).set_palette(worldOf(L), &range, &entry));
    }
}

/// Makes the body of Box() and Ball() with its shape, gives both their tag, and returns both. A body whose shape is
/// refused goes again.
int finishBody(lua_State* L, rubble_shape_settings& settings, const Vector& corner, int options) {
    const std::string tag = textAt(L, 1, "tag");
    settings.body = makeBody(L, corner, options);
    rubble_shape shape = 0;
    const rubble_result result = apiOf(L).create_shape(worldOf(L), &settings, &shape);
    if (result != RUBBLE_OK) {
        ScriptContext::of(L).shared.pending.created.erase(settings.body);
        apiOf(L).destroy_body(worldOf(L), settings.body);
    }
    isDone(L, result);
    made(L, shape, RUBBLE_KIND_SHAPE);
    tint(L, shape, settings.index);
    if (!tag.empty())
        for (const uint64_t object : {settings.body, shape}) {
            isDone(L, apiOf(L).set_tag(worldOf(L), object, tag.c_str(), nullptr));
            ScriptContext::of(L).shared.pending.tags[{object, tag}] = "";
        }
    pushHandle(L, shape);
    pushHandle(L, settings.body);
    return 2;
}

rubble_shape_settings shapeSettings(lua_State* L, uint32_t source, int entry, int options) {
    checkOptions(L, options, {"dynamic", "asleep", "velocity", "spin", "turned", "voxel"});
    auto shape = sized<rubble_shape_settings>();
    shape.source = source;
    shape.index = uint32_t(wholeIn(L, entry, "entry", numberOr(L, entry, "entry", 6.0), 1.0, 255.0));
    shape.voxel_size = optionNumber(L, options, "voxel", 0.1);
    shape.rotation[3] = 1.0;
    return shape;
}

int box(lua_State* L) {
    auto shape = shapeSettings(L, RUBBLE_SHAPE_BOX, 4, 5);
    const Vector cells = vectorAt(L, 3, "cells");
    for (size_t axis = 0; axis < 3; ++axis)
        shape.size[axis] = int32_t(wholeIn(L, 3, "cells", cells[axis], 1.0, 4096.0));
    return finishBody(L, shape, vectorAt(L, 2, "corner"), 5);
}

int ball(lua_State* L) {
    auto shape = shapeSettings(L, RUBBLE_SHAPE_SPHERE, 4, 5);
    std::fill_n(shape.size, 3, int32_t(wholeIn(L, 3, "cells", numberAt(L, 3, "cells"), 1.0, 512.0)));
    const double half = 0.5 * shape.size[0] * shape.voxel_size;
    return finishBody(L, shape, vectorAt(L, 2, "center") - Vector{half, half, half}, 5);
}

uint32_t jointKind(lua_State* L) {
    static constexpr struct {
        const char* name;
        uint32_t kind;
    } kKinds[] = {{"ball", RUBBLE_JOINT_BALL},           {"hinge", RUBBLE_JOINT_HINGE}, {"fixed", RUBBLE_JOINT_FIXED},
                  {"prismatic", RUBBLE_JOINT_PRISMATIC}, {"rope", RUBBLE_JOINT_ROPE},   {"wheel", RUBBLE_JOINT_WHEEL}};
    const std::string name = textAt(L, 1, "kind");
    for (const auto& row : kKinds)
        if (name == row.name) return row.kind;
    refuseArgument(L, 1, "kind", "\"ball\", \"hinge\", \"fixed\", \"prismatic\", \"rope\" or \"wheel\"");
}

void setMotor(lua_State* L, int options, rubble_joint_settings& joint) {
    const double speed = optionNumber(L, options, "speed", NAN), target = optionNumber(L, options, "target", NAN);
    if (!std::isnan(speed)) joint.motor = RUBBLE_MOTOR_SPEED, joint.motor_target = speed;
    if (!std::isnan(target)) joint.motor = RUBBLE_MOTOR_POSITION, joint.motor_target = target;
    joint.motor_max_force = optionNumber(L, options, "force", 0.0);
    joint.lower_limit = optionNumber(L, options, "low", 0.0);
    joint.upper_limit = optionNumber(L, options, "high", 0.0);
    if (joint.lower_limit < joint.upper_limit) joint.flags |= RUBBLE_JOINT_LIMITED;
}

int joint(lua_State* L) {
    checkOptions(L, 5,
                 {"axis", "rope_end", "length", "strength", "break_force", "low", "high", "speed", "target", "force",
                  "hertz", "damping", "friction", "drive", "brake", "steer", "anchor_radius"});
    auto settings = sized<rubble_joint_settings>();
    settings.kind = jointKind(L);
    settings.shapes[0] = handleAt(L, 2, "first");
    settings.shapes[1] = handleAt(L, 3, "second");
    copy(settings.position, vectorAt(L, 4, "pos"));
    copy(settings.rotation, axisRotation(optionVector(L, 5, "axis", {1.0, 0.0, 0.0})));
    copy(settings.rope_end, optionVector(L, 5, "rope_end", {}));
    settings.anchor_radius = optionNumber(L, 5, "anchor_radius", 0.5);
    settings.rope_length = optionNumber(L, 5, "length", 0.0);
    settings.rope_strength = optionNumber(L, 5, "strength", 0.0);
    settings.break_force = optionNumber(L, 5, "break_force", 0.0);
    settings.spring_hertz = optionNumber(L, 5, "hertz", 0.0);
    settings.spring_damping_ratio = optionNumber(L, 5, "damping", 0.0);
    settings.friction = optionNumber(L, 5, "friction", 0.0);
    settings.drive_torque = optionNumber(L, 5, "drive", 0.0);
    settings.brake_torque = optionNumber(L, 5, "brake", 0.0);
    settings.max_steer_angle = optionNumber(L, 5, "steer", 0.0);
    setMotor(L, 5, settings);
    rubble_joint out = 0;
    isDone(L, apiOf(L).create_joint(worldOf(L), &settings, &out));
    pushHandle(L, made(L, out, RUBBLE_KIND_JOINT));
    return 1;
}

int collideAs(lua_State* L) {
    static constexpr const char* kShapes[] = {"voxels", "sphere", "cylinder x", "cylinder y", "cylinder z"};
    auto settings = sized<rubble_collision_shape>();
    settings.shape = handleAt(L, 1, "shape");
    const std::string name = textAt(L, 2, "kind");
    const auto* found = std::find(std::begin(kShapes), std::end(kShapes), name);
    if (found == std::end(kShapes)) refuseArgument(L, 2, "kind", "\"voxels\", \"sphere\" or \"cylinder x\", y or z");
    settings.kind = uint32_t(found - kShapes);
    isDone(L, apiOf(L).set_collision_shape(worldOf(L), &settings));
    return 0;
}

int drive(lua_State* L) {
    auto settings = sized<rubble_drive>();
    settings.body = handleAt(L, 1, "body");
    settings.throttle = numberOr(L, 2, "throttle", 0.0);
    settings.steer = numberOr(L, 3, "steer", 0.0);
    settings.brake = numberOr(L, 4, "brake", 0.0);
    isDone(L, apiOf(L).drive_wheels(worldOf(L), &settings));
    return 0;
}

int water(lua_State* L) {
    checkOptions(L, 3, {"flow"});
    const Vector low = vectorAt(L, 1, "low"), high = vectorAt(L, 2, "high");
    const double outline[] = {low[0], low[2], high[0], low[2], high[0], high[2], low[0], high[2]};
    auto settings = sized<rubble_water_settings>();
    settings.outline = outline;
    settings.outline_count = 4;
    settings.surface_height = high[1];
    settings.depth = high[1] - low[1];
    copy(settings.flow, optionVector(L, 3, "flow", {}));
    rubble_water out = 0;
    isDone(L, apiOf(L).create_water(worldOf(L), &settings, &out));
    pushHandle(L, made(L, out, RUBBLE_KIND_WATER));
    return 1;
}

int removeWater(lua_State* L) {
    isDone(L, apiOf(L).remove_water(worldOf(L), handleAt(L, 1, "water")));
    return 0;
}

int character(lua_State* L) {
    auto settings = sized<rubble_character_settings>();
    copy(settings.position, vectorAt(L, 1, "pos"));
    rubble_character out = 0;
    isDone(L, apiOf(L).create_character(worldOf(L), &settings, &out));
    pushHandle(L, made(L, out, RUBBLE_KIND_CHARACTER));
    return 1;
}

int walk(lua_State* L) {
    auto move = sized<rubble_character_move>();
    move.character = handleAt(L, 1, "character");
    copy(move.desired_velocity, vectorAt(L, 2, "velocity"));
    if (boolOr(L, 3, false)) move.flags = RUBBLE_MOVE_JUMP;
    isDone(L, apiOf(L).move_character(worldOf(L), &move));
    return 0;
}

int lightGroup(lua_State* L) {
    auto settings = sized<rubble_light_group_settings>();
    settings.threshold = numberOr(L, 1, "threshold", 0.4);
    rubble_light_group out = 0;
    isDone(L, apiOf(L).create_light_group(worldOf(L), &settings, &out));
    pushHandle(L, made(L, out, RUBBLE_KIND_LIGHT_GROUP));
    return 1;
}

int switchLightGroup(lua_State* L) {
    auto change = sized<rubble_light_group_change>();
    change.fields = RUBBLE_GROUP_SWITCH;
    change.group = handleAt(L, 1, "group");
    change.on = boolOr(L, 2, true);
    isDone(L, apiOf(L).set_light_group(worldOf(L), &change));
    return 0;
}

int glow(lua_State* L) {
    auto range = sized<rubble_palette_range>();
    range.shape = handleAt(L, 1, "shape");
    range.first = uint32_t(wholeIn(L, 2, "entry", numberAt(L, 2, "entry"), 1.0, 255.0));
    range.count = 1;
    rubble_palette_entry entry = {};
    std::fill_n(entry.color, 3, uint8_t(255));
    entry.opacity = 255, entry.roughness = 200, entry.material = uint8_t(range.first);
    entry.emission = numberAt(L, 3, "emission");
    entry.light_group = lua_isnoneornil(L, 4) ? 0 : handleAt(L, 4, "group");
    isDone(L, apiOf(L).set_palette(worldOf(L), &range, &entry));
    return 0;
}

int addLight(lua_State* L) {
    auto light = sized<rubble_light_settings>();
    light.kind = RUBBLE_LIGHT_SPHERE;
    light.flags = RUBBLE_LIGHT_ENABLED;
    copy(light.position, vectorAt(L, 1, "pos"));
    light.shape = lua_isnoneornil(L, 2) ? 0 : handleAt(L, 2, "shape");
    light.group = lua_isnoneornil(L, 3) ? 0 : handleAt(L, 3, "group");
    light.rotation[3] = 1.0;
    std::fill_n(light.color, 3, 10.0);
    light.radius = 0.1;
    light.reach = 10.0;
    rubble_light out = 0;
    isDone(L, apiOf(L).create_light(worldOf(L), &light, &out));
    pushHandle(L, made(L, out, RUBBLE_KIND_LIGHT));
    return 1;
}

int pour(lua_State* L) {
    auto edit = sized<rubble_extinguish>();
    copy(edit.position, vectorAt(L, 1, "pos"));
    edit.radius = numberOr(L, 2, "radius", 1.0);
    edit.wet_seconds = 20.0;
    isDone(L, apiOf(L).extinguish(worldOf(L), &edit));
    return 0;
}

/// A field of rubble_settings that scenarios may set.
template <class T>
void setOption(lua_State* L, const char* name, T& field) {
    const double value = optionNumber(L, 1, name, double(field));
    if (!(value >= 0.0)) luaL_error(L, "Settings: %s: expected a number of at least 0, found %f", name, value);
    field = T(value);
}

void setFlag(lua_State* L, const char* name, uint32_t bit, uint32_t& flags) {
    lua_pushstring(L, name);
    lua_rawget(L, 1);
    if (!lua_isnil(L, -1)) flags = lua_toboolean(L, -1) ? flags | bit : flags & ~bit;
    lua_pop(L, 1);
}

int settings(lua_State* L) {
    if (!lua_istable(L, 1)) refuseArgument(L, 1, "table", "a table");
    checkOptions(L, 1,
                 {"stress", "fire", "paint_layer", "debris_bodies", "debris_voxels", "awake_debris_bodies",
                  "largest_debris", "min_piece_voxels", "settle_steps", "split_parts", "max_fires", "impact_threshold",
                  "fire_spread", "strength_scale"});
    auto values = sized<rubble_settings>();
    isDone(L, apiOf(L).get_settings(worldOf(L), &values));
    setFlag(L, "stress", RUBBLE_SETTING_STRESS, values.flags);
    setFlag(L, "fire", RUBBLE_SETTING_FIRE, values.flags);
    setFlag(L, "paint_layer", RUBBLE_SETTING_PAINT_LAYER, values.flags);
    setOption(L, "debris_bodies", values.debris_bodies);
    setOption(L, "debris_voxels", values.debris_voxels);
    setOption(L, "awake_debris_bodies", values.awake_debris_bodies);
    setOption(L, "largest_debris", values.largest_debris);
    setOption(L, "min_piece_voxels", values.min_piece_voxels);
    setOption(L, "settle_steps", values.settle_steps);
    setOption(L, "split_parts", values.split_parts);
    setOption(L, "max_fires", values.max_fires);
    setOption(L, "impact_threshold", values.impact_threshold);
    setOption(L, "fire_spread", values.fire_spread);
    setOption(L, "strength_scale", values.strength_scale);
    isDone(L, apiOf(L).set_settings(worldOf(L), &values));
    return 0;
}

int bounds(lua_State* L) {
    auto values = sized<rubble_bounds>();
    copy(values.low, vectorAt(L, 1, "low"));
    copy(values.high, vectorAt(L, 2, "high"));
    isDone(L, apiOf(L).set_bounds(worldOf(L), &values));
    return 0;
}

int undoLimit(lua_State* L) {
    const double marks = wholeIn(L, 1, "marks", numberAt(L, 1, "marks"), 0.0, 1000.0);
    isDone(L, apiOf(L).set_undo_limit(worldOf(L), uint32_t(marks)));
    return 0;
}
int undoMark(lua_State* L) {
    isDone(L, apiOf(L).add_undo_mark(worldOf(L)));
    return 0;
}
int undo(lua_State* L) {
    requestsOf(L).undoWaits |= isDone(L, apiOf(L).undo(worldOf(L)));
    return 0;
}
int redo(lua_State* L) {
    requestsOf(L).undoWaits |= isDone(L, apiOf(L).redo(worldOf(L)));
    return 0;
}

int saveAndLoad(lua_State* L) {
    requestsOf(L).waiting.push_back({SceneRequests::SaveAndLoad, {}});
    return 0;
}
int loadLevel(lua_State* L) {
    const std::string name = textAt(L, 1, "name");
    if (name != "town" && name != "bridge" && name != "garden")
        refuseArgument(L, 1, "name", "\"town\", \"bridge\" or \"garden\"");
    requestsOf(L).waiting.push_back({SceneRequests::LoadLevel, name});
    return 0;
}

int waitForStepNumber(lua_State* L) {
    return waitUntil(L, numberAt(L, 1, "step") / 60.0);
}

int expect(lua_State* L) {
    std::string& unmet = requestsOf(L).unmet;
    if (!lua_toboolean(L, 1) && unmet.empty()) unmet = textAt(L, 2, "what");
    return 0;
}

int closedSystem(lua_State* L) {
    requestsOf(L).isClosed = boolOr(L, 1, true);
    return 0;
}

int freeFlight(lua_State* L) {
    requestsOf(L).isFree = boolOr(L, 1, true);
    return 0;
}

constexpr const char* kBoxFields = "angular_velocity spin, position corner, size cells, voxel_size voxel";

constexpr const char* kJointFields =
    "anchor_radius anchor_radius, brake_torque brake, break_force break_force, drive_torque drive, lower_limit low, "
    "max_steer_angle steer, motor_max_force force, motor_target speed or target, rope_end rope_end, rope_length "
    "length, rope_strength strength, rotation axis, spring_damping_ratio damping, spring_hertz hertz, upper_limit high";

constexpr ScriptFunction kFunctions[] = {
    {"Box(tag, corner, cells, entry, options) -> shape, body",
     "A body of a full box; it is static unless options.dynamic. Options: dynamic, asleep, velocity, spin, turned, "
     "voxel.",
     box, 0, kBoxFields},
    {"Ball(tag, center, cells, entry, options) -> shape, body", "The same as a ball of so many cells across.", ball, 0,
     kBoxFields},
    {"Joint(kind, first, second, pos, options) -> joint",
     "\"ball\", \"hinge\", \"fixed\", \"prismatic\", \"rope\" or \"wheel\" between two shapes, or a shape and 0, the "
     "world. "
     "Options: axis, rope_end, length, strength, break_force, low, high, speed, target, force, hertz, damping, "
     "friction, "
     "drive, brake, steer, anchor_radius.",
     joint, 0, kJointFields},
    {"CollideAs(shape, kind)", "What physics takes a shape for: \"voxels\", \"sphere\", \"cylinder x\", y or z.",
     collideAs},
    {"Drive(body, throttle, steer, brake)", "Drives the wheels of a body, -1 to 1.", drive},
    {"Water(low, high, options) -> water", "Water in a box; options: flow.", water, 0,
     "depth high, outline low, surface_height high"},
    {"RemoveWater(water)", "Removes it.", removeWater},
    {"Character(pos) -> character", "Who walks, with the feet at a place.", character},
    {"Walk(character, velocity, jumps)", "Where it goes, in m/s, until the next such call.", walk},
    {"LightGroup(threshold) -> group", "A light group.", lightGroup},
    {"SwitchLightGroup(group, on)", "Switches it.", switchLightGroup},
    {"Glow(shape, entry, emission, group)",
     "Lets voxels of an entry of a shape's palette glow, of a light group or none.", glow},
    {"AddLight(pos, shape, group) -> light", "A small light on a shape, or in the world, of a light group or none.",
     addLight},
    {"Pour(pos, radius)", "Pours water: fires go out there.", pour},
    {"Settings(table)", "Sets settings of the world by their names in rubble.h.", settings},
    {"Bounds(low, high)", "Where the world ends.", bounds},
    {"UndoLimit(marks)", "How many undo marks are kept.", undoLimit},
    {"UndoMark()", "Adds an undo mark.", undoMark},
    {"Undo()", "Goes back to the last one.", undo},
    {"Redo()", "Goes forward again.", redo},
    {"SaveAndLoad()", "Saves the game after this step, and loads it. Handles are others then.", saveAndLoad},
    {"LoadLevel(name)", "Loads \"town\", \"bridge\" or \"garden\" after this step. Handles are others then.",
     loadLevel},
    {"WaitForStep(step)", "As wait(), until a step of the run.", waitForStepNumber},
    {"Expect(condition, what)", "Says what shall hold: the run fails if it does not.", expect},
    {"ClosedSystem(on)", "From here on nothing gives energy to bodies: what they gain fails the run.", closedSystem},
    {"FreeFlight(on)", "From here on no body touches anything: pieces go on as their bodies moved.", freeFlight},
    {"Cut(shape, pos, half, rot)", "Removes its voxels in a box: the middle, half the size in metres, the rotation.",
     cut},
    {"ExactHole(shape, cell, radius)",
     "Removes a ball of a shape, in cells of its grid, and expects that those voxels go whose centres are in it. Into "
     "voxels that nothing else removes in that step, but for other such calls.",
     exactHole},
};

}  // namespace

std::span<const ScriptFunction> sceneFunctions() {
    return kFunctions;
}

}  // namespace stress
