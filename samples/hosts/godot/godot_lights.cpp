#include "samples/hosts/godot/godot_lights.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "samples/hosts/godot/spatial_math.h"
#include "samples/hosts/godot/voxel_world.h"

namespace rubble_godot {
namespace {

const Method kChildCount{"Node", "get_child_count"}, kChild{"Node", "get_child"}, kGetClass{"Object", "get_class"},
    kGetTransform{"Spatial", "get_global_transform"}, kIsVisible{"Spatial", "is_visible_in_tree"},
    kGetColor{"Light", "get_color"}, kGetParam{"Light", "get_param"};
constexpr int32_t kEnergy = 0, kRange = 3, kSpotAngle = 5;  // Light.PARAM_...
// Godot's energies have no unit. An energy of 1 gets so many W/sr: about as bright on voxels as on Godot's meshes.
constexpr double kIntensity = 4.0;

double toLinear(double srgb) {
    return std::pow(std::max(srgb, 0.0), 2.2);
}

}  // namespace

void GodotLights::forget() {
    m_lights.clear();
    std::fill(m_sun, m_sun + 3, 0.0);
}

void GodotLights::follow() {
    const int64_t count = kChildCount(m_owner.node()).as<int64_t>();
    std::set<gd::Object*> present;
    for (int64_t i = 0; i < count; ++i) {
        gd::Object* const child = kChild(m_owner.node(), i).as<gd::Object*>();
        const std::string name = kGetClass(child).as<std::string>();
        if (name == "DirectionalLight") followSun(child);
        if (name != "OmniLight" && name != "SpotLight") continue;
        followLight(child, name == "SpotLight");
        present.insert(child);
    }
    std::erase_if(m_lights, [&](const auto& entry) {
        if (present.count(entry.first)) return false;
        m_owner.check(m_owner.api().remove_light(m_owner.world(), entry.second.light), "OmniLight");
        return true;
    });
}

void GodotLights::followSun(gd::Object* light) {
    const Transform place = kGetTransform(light).as<Transform>();
    const double sun[3] = {place.rows[0][2], place.rows[1][2], place.rows[2][2]};  // it shines along -z
    if (std::equal(sun, sun + 3, m_sun)) return;
    rubble_environment environment = {.struct_size = sizeof environment};
    const rubble_api& api = m_owner.api();
    if (!m_owner.check(api.get_environment(m_owner.world(), &environment), "DirectionalLight")) return;
    std::copy(sun, sun + 3, environment.sun_direction);
    if (!m_owner.check(api.apply_sky_model(&environment, sun), "DirectionalLight")) return;
    if (m_owner.check(api.set_environment(m_owner.world(), &environment), "DirectionalLight"))
        std::copy(sun, sun + 3, m_sun);
}

void GodotLights::followLight(gd::Object* light, bool isSpot) {
    rubble_light_settings settings = {.struct_size = sizeof settings};
    const Transform place = kGetTransform(light).as<Transform>();
    const Color color = kGetColor(light).as<Color>();
    const double energy = kGetParam(light, kEnergy).as<double>();
    settings.kind = isSpot ? RUBBLE_LIGHT_CONE : RUBBLE_LIGHT_SPHERE;
    settings.flags = kIsVisible(light).as<bool>() ? RUBBLE_LIGHT_ENABLED : 0;
    copy(place.origin, settings.position);
    toQuaternion(place, settings.rotation);
    for (size_t i = 0; i < 3; ++i) settings.color[i] = kIntensity * energy * toLinear(color[i]);
    settings.radius = 0.05;
    settings.reach = kGetParam(light, kRange).as<double>();
    if (isSpot) settings.cone_outer = kGetParam(light, kSpotAngle).as<double>() * std::acos(-1.0) / 180.0;
    if (isSpot) settings.cone_inner = 0.8 * settings.cone_outer;
    const auto found = m_lights.find(light);
    if (found == m_lights.end()) {
        rubble_light handle = 0;
        if (!m_owner.check(m_owner.api().create_light(m_owner.world(), &settings, &handle), "OmniLight")) return;
        settings.light = handle;
        m_lights[light] = settings;
        return;
    }
    settings.light = found->second.light;
    if (std::memcmp(&settings, &found->second, sizeof settings) == 0) return;
    m_owner.check(m_owner.api().set_light(m_owner.world(), &settings), "OmniLight");
    found->second = settings;
}

}  // namespace rubble_godot
