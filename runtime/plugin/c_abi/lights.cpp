#include <algorithm>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/world/level/sky_model.h"

namespace rubble::abi {
namespace {

/// A number that two structs have: a float of the engine's and a double of the host's.
template <class Engine, class Host>
struct Scalar {
    float Engine::*engine;
    double Host::*host;
};
/// The same for three numbers.
template <class Engine, class Host>
struct Vector {
    glm::vec3 Engine::*engine;
    double (Host::*host)[3];
};

constexpr Scalar<Environment, rubble_environment> kEnvironmentScalars[] = {
    {&Environment::sunAngle, &rubble_environment::sun_angle},
    {&Environment::fogDistance, &rubble_environment::fog_distance},
    {&Environment::fogDensity, &rubble_environment::fog_density},
    {&Environment::fogBase, &rubble_environment::fog_base},
    {&Environment::fogHeight, &rubble_environment::fog_height},
    {&Environment::fogForward, &rubble_environment::fog_forward},
    {&Environment::clouds, &rubble_environment::clouds},
    {&Environment::stars, &rubble_environment::stars},
    {&Environment::exposure, &rubble_environment::exposure},
    {&Environment::wetness, &rubble_environment::wetness},
};
constexpr Vector<Environment, rubble_environment> kEnvironmentVectors[] = {
    {&Environment::sunDirection, &rubble_environment::sun_direction},
    {&Environment::sunColor, &rubble_environment::sun_color},
    {&Environment::skyColor, &rubble_environment::sky_color},
    {&Environment::horizonColor, &rubble_environment::horizon_color},
    {&Environment::groundColor, &rubble_environment::ground_color},
    {&Environment::fogColor, &rubble_environment::fog_color},
    {&Environment::fogTint, &rubble_environment::fog_tint},
    {&Environment::gravity, &rubble_environment::gravity},
};
constexpr Scalar<Light, rubble_light_settings> kLightScalars[] = {
    {&Light::radius, &rubble_light_settings::radius},        {&Light::reach, &rubble_light_settings::reach},
    {&Light::coneInner, &rubble_light_settings::cone_inner}, {&Light::coneOuter, &rubble_light_settings::cone_outer},
    {&Light::width, &rubble_light_settings::width},          {&Light::height, &rubble_light_settings::height},
};
constexpr Vector<Light, rubble_light_settings> kLightVectors[] = {
    {&Light::color, &rubble_light_settings::color},
};

/// Doubles that a float cannot hold become numbers that are out of every range. NaN stays.
float toFloat(double value) {
    return float(std::clamp(value, -1e30, 1e30));
}
template <class Engine, class Host>
void read(const Scalar<Engine, Host>& field, const Host& from, Engine& to) {
    to.*field.engine = toFloat(from.*field.host);
}
template <class Engine, class Host>
void read(const Vector<Engine, Host>& field, const Host& from, Engine& to) {
    for (int i = 0; i < 3; ++i) (to.*field.engine)[i] = toFloat((from.*field.host)[i]);
}
template <class Engine, class Host>
void write(const Scalar<Engine, Host>& field, const Engine& from, Host& to) {
    to.*field.host = double(from.*field.engine);
}
template <class Engine, class Host>
void write(const Vector<Engine, Host>& field, const Engine& from, Host& to) {
    writeVector(to.*field.host, glm::dvec3(from.*field.engine));
}

Environment readEnvironment(const rubble_environment& given) {
    Environment out;
    for (const auto& field : kEnvironmentScalars) read(field, given, out);
    for (const auto& field : kEnvironmentVectors) read(field, given, out);
    requireNoError(environmentError(out));
    return out;
}

rubble_environment toHost(const Environment& from) {
    rubble_environment out = {};
    for (const auto& field : kEnvironmentScalars) write(field, from, out);
    for (const auto& field : kEnvironmentVectors) write(field, from, out);
    return out;
}

const Light* findLight(const World& world, rubble_light bits) {
    return findLive<HandleType::Light>(world.lights(), bits, "light");
}

rubble_light_settings toHost(LightHandle handle, const Light& from) {
    rubble_light_settings out = {};
    for (const auto& field : kLightScalars) write(field, from, out);
    for (const auto& field : kLightVectors) write(field, from, out);
    out.light = handle.bits;
    out.kind = uint32_t(from.kind);
    out.flags = (from.enabled ? RUBBLE_LIGHT_ENABLED : 0) | (from.twoSided ? RUBBLE_LIGHT_TWO_SIDED : 0);
    out.shape = from.shape.bits;
    out.group = from.group.bits;
    writeVector(out.position, from.local.position);
    writeRotation(out.rotation, from.local.rotation);
    return out;
}

/// `light` with all values that the host can give; its name and image stay.
Light readLight(const World& world, const rubble_light_settings& given, Light light) {
    readFlags(given.flags, RUBBLE_LIGHT_ENABLED | RUBBLE_LIGHT_TWO_SIDED, "flags");
    for (const auto& field : kLightScalars) read(field, given, light);
    for (const auto& field : kLightVectors) read(field, given, light);
    light.kind = LightKind(std::min(given.kind, 255u));  // lightError() refuses unknown kinds
    light.shape = readOptionalHandle<HandleType::Shape>(world.shapes(), given.shape, "shape");
    light.group = readOptionalHandle<HandleType::LightGroup>(world.lightGroups(), given.group, "group");
    light.local = {readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    light.enabled = given.flags & RUBBLE_LIGHT_ENABLED;
    light.twoSided = given.flags & RUBBLE_LIGHT_TWO_SIDED;
    requireNoError(lightError(light));
    return light;
}

rubble_result getEnvironment(rubble_world world, rubble_environment* out) {
    return inWorld("get_environment", world,
                   [&](const HostedWorld& hosted) { writeStruct(out, toHost(hosted.loop.world().environment())); });
}

rubble_result setEnvironment(rubble_world world, const rubble_environment* environment) {
    return pushEdit(
        "set_environment", world, environment, "environment",
        [](const World&, const rubble_environment& given) { return SetEnvironmentEdit{readEnvironment(given)}; });
}

rubble_result applySky(rubble_environment* environment, const double* sunDirection) {
    return guarded("apply_sky_model", [&] {
        Environment now = readEnvironment(readStruct(environment, "environment"));
        const glm::vec3 sun(readDirectionAt(sunDirection, "sun_direction"));
        if (isRefused()) return;
        applySkyModel(now, sun);
        writeStruct(environment, toHost(now));
    });
}

rubble_result getLights(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count) {
    return listAll("get_lights", world, out, capacity, count, &World::lights);
}

rubble_result getLightSettings(rubble_world world, rubble_light light, rubble_light_settings* out) {
    return inWorld("get_light_settings", world, [&](const HostedWorld& hosted) {
        const Light* found = findLight(hosted.loop.world(), light);
        if (found) writeStruct(out, toHost(LightHandle{light}, *found));
    });
}

rubble_result setLight(rubble_world world, const rubble_light_settings* light) {
    return pushEdit("set_light", world, light, "light", [](const World& in, const rubble_light_settings& given) {
        const LightHandle handle = readLiveHandle<HandleType::Light>(in.lights(), given.light, "light");
        const Light* present = in.lights().find(handle);  // null: it is made by the step
        return SetLightEdit{handle, readLight(in, given, present ? *present : Light{})};
    });
}

AddLightEdit readNewLight(const World& world, const rubble_light_settings& given) {
    return {readLight(world, given, {})};
}
rubble_result addLight(rubble_world world, const rubble_light_settings* light) {
    return pushEdit("add_light", world, light, "light", readNewLight);
}
rubble_result createLight(rubble_world world, const rubble_light_settings* light, rubble_light* out) {
    return pushMaker("create_light", world, light, out, &WorldObjects::lights, readNewLight);
}

rubble_result removeLight(rubble_world world, rubble_light light) {
    return removeOne<RemoveLightEdit, HandleType::Light>("remove_light", world, light, "light", &World::lights);
}

rubble_result getAddedLights(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count) {
    return listRows<rubble_light>("get_added_lights", world, out, capacity, count,
                                  [](const HostedWorld& hosted, auto& rows) {
                                      for (const LightHandle light : hosted.loop.changes().lightsAdded)
                                          rows.add([&] { return light.bits; });
                                  });
}

}  // namespace

void setLightFunctions(rubble_api& api) {
    api.get_environment = getEnvironment;
    api.set_environment = setEnvironment;
    api.apply_sky_model = applySky;
    api.get_lights = getLights;
    api.get_light_settings = getLightSettings;
    api.set_light = setLight;
    api.add_light = addLight;
    api.create_light = createLight;
    api.remove_light = removeLight;
    api.get_added_lights = getAddedLights;
}

}  // namespace rubble::abi
