#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

/// The settings of the light of argument 1; false: it is gone.
bool readLight(lua_State* L, rubble_light_settings& light) {
    light = sized<rubble_light_settings>();
    return isDone(L, apiOf(L).get_light_settings(worldOf(L), handleAt(L, 1, "light"), &light));
}

/// The same as calls of this step have left them: the interface sets all of a light at once.
bool readChanged(lua_State* L, rubble_light_settings& light) {
    const auto& changed = ScriptContext::of(L).shared.pending.lights;
    const auto found = changed.find(handleAt(L, 1, "light"));
    if (found == changed.end()) return readLight(L, light);
    light = found->second;
    return true;
}

int write(lua_State* L, const rubble_light_settings& light) {
    if (isDone(L, apiOf(L).set_light(worldOf(L), &light)))
        ScriptContext::of(L).shared.pending.lights[light.light] = light;
    return 0;
}

int setEnabled(lua_State* L) {
    rubble_light_settings light;
    if (!readChanged(L, light)) return 0;
    light.flags =
        boolOr(L, 2, true) ? light.flags | RUBBLE_LIGHT_ENABLED : light.flags & ~uint32_t(RUBBLE_LIGHT_ENABLED);
    return write(L, light);
}

/// W/sr of a light of intensity 0: far below what is seen, and keeps its colour.
constexpr double kNoIntensity = 1e-30;

double brightness(const rubble_light_settings& light) {
    const double largest = *std::max_element(light.color, light.color + 3);
    return largest > 2.0 * kNoIntensity ? largest : 0.0;
}

int setColor(lua_State* L) {
    const Vector color{numberAt(L, 2, "r"), numberAt(L, 3, "g"), numberAt(L, 4, "b")};
    for (int i = 0; i < 3; ++i) {
        static constexpr const char* kNames[] = {"r", "g", "b"};
        if (!(color[size_t(i)] >= 0.0)) refuseArgument(L, 2 + i, kNames[i], "0 or more");
    }
    rubble_light_settings light;
    if (!readChanged(L, light)) return 0;
    const double largest = std::max({color[0], color[1], color[2], 1e-9});
    const double intensity = std::max(*std::max_element(light.color, light.color + 3), kNoIntensity);
    copy(light.color, color * (intensity / largest));
    return write(L, light);
}

int setIntensity(lua_State* L) {
    const double intensity = numberAt(L, 2, "intensity");
    rubble_light_settings light;
    if (!readChanged(L, light)) return 0;
    const double before = *std::max_element(light.color, light.color + 3);
    const double now = intensity == 0.0 ? kNoIntensity : intensity;
    for (double& channel : light.color) channel = before > 0.0 ? channel / before * now : now;
    return write(L, light);
}

/// Where a light is in the world.
Placement placeOf(lua_State* L, const rubble_light_settings& light) {
    const Placement own = placementOf(light.position, light.rotation);
    rubble_shape_state shape = {};
    if (!light.shape || !isDone(L, apiOf(L).get_shape_state(worldOf(L), light.shape, &shape))) return own;
    const Placement frame = placementOf(shape.position, shape.rotation);
    return {toParent(frame, own.position), frame.rotation * own.rotation};
}

int getTransform(lua_State* L) {
    rubble_light_settings light;
    pushPlacement(L, readLight(L, light) ? placeOf(L, light) : Placement{});
    return 1;
}

int getShape(lua_State* L) {
    rubble_light_settings light;
    pushHandle(L, readLight(L, light) ? light.shape : 0);
    return 1;
}

bool isOn(lua_State* L, const rubble_light_settings& light) {
    if (!(light.flags & RUBBLE_LIGHT_ENABLED) || brightness(light) <= 0.0) return false;
    if (!light.group) return true;
    auto group = sized<rubble_light_group_state>();
    isDone(L, apiOf(L).get_light_group(worldOf(L), light.group, &group));
    return (group.flags & RUBBLE_GROUP_ON) && !(group.flags & RUBBLE_GROUP_OUT);
}

int isActive(lua_State* L) {
    rubble_light_settings light;
    lua_pushboolean(L, readLight(L, light) && isOn(L, light));
    return 1;
}

/// Within its reach and its cone, with nothing opaque between.
bool reaches(lua_State* L, const rubble_light_settings& light, const Vector& point) {
    const Placement place = placeOf(L, light);
    const Vector way = point - place.position;
    const double distance = length(way);
    if (distance > light.reach) return false;
    if (distance <= light.radius) return true;
    const Vector along = normalized(way), ahead = rotated(place.rotation, {0.0, 0.0, -1.0});
    if (light.kind == RUBBLE_LIGHT_CONE && dot(along, ahead) < std::cos(light.cone_outer)) return false;
    rubble_ray ray = {};
    copy(ray.origin, point);
    copy(ray.direction, along * -1.0);
    ray.max_distance = distance - light.radius;
    auto filter = sized<rubble_query_filter>();
    filter.flags = RUBBLE_FILTER_REJECT_TRANSPARENT;
    filter.rejected_shapes = &light.shape;
    filter.rejected_shape_count = light.shape ? 1 : 0;
    rubble_hit hit = {};
    isDone(L, apiOf(L).cast_rays(worldOf(L), &ray, 1, &filter, &hit));
    return !hit.hit;
}

int isPointAffected(lua_State* L) {
    const Vector point = vectorAt(L, 2, "point");
    rubble_light_settings light;
    lua_pushboolean(L, readLight(L, light) && isOn(L, light) && reaches(L, light, point));
    return 1;
}

int pointLight(lua_State* L) {
    auto light = sized<rubble_light_settings>();
    light.kind = RUBBLE_LIGHT_SPHERE;
    light.flags = RUBBLE_LIGHT_ENABLED;
    copy(light.position, vectorAt(L, 1, "pos"));
    light.rotation[3] = 1.0;
    const double intensity = numberOr(L, 5, "intensity", 1.0);
    const char* const names[] = {"r", "g", "b"};
    for (int i = 0; i < 3; ++i) light.color[i] = std::clamp(numberOr(L, 2 + i, names[i], 1.0) * intensity, 0.0, 1e6);
    light.radius = 0.1;
    light.reach = 20.0;
    rubble_light made = 0;
    ScriptWorld& shared = ScriptContext::of(L).shared;
    if (!isDone(L, apiOf(L).create_light(worldOf(L), &light, &made))) return 0;
    isDone(L, apiOf(L).set_tag(worldOf(L), made, kPointLightTag, nullptr));
    shared.pointLights[made] = shared.step;
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"SetLightEnabled(light, enabled)", "Switches a light.", setEnabled, 30},
    {"SetLightColor(light, r, g, b)", "Its colour, 0 to 1: the ratio of r, g and b counts, its intensity stays.",
     setColor, 30},
    {"SetLightIntensity(light, intensity)", "Its intensity in W/sr; its colour stays.", setIntensity, 30},
    {"GetLightTransform(light) -> transform", "Where it is; cones and areas face -z.", getTransform},
    {"GetLightShape(light) -> shape", "The shape that it is on, or 0.", getShape},
    {"IsLightActive(light) -> boolean", "Whether it shines: it is enabled, and its group is on.", isActive},
    {"IsPointAffectedByLight(light, point) -> boolean",
     "Whether its light reaches a point, with nothing opaque between.", isPointAffected},
    {"PointLight(pos, r, g, b, intensity)", "A light for one step.", pointLight, 50},
};

}  // namespace

std::span<const ScriptFunction> lightFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
