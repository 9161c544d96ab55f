#include "runtime/plugin/c_abi/lights.h"

#include <algorithm>

#include "runtime/plugin/c_abi/guard.h"
#include "runtime/world/level/sky_model.h"

namespace rubble::abi {
namespace {

/// Where a number, or three, of one struct is in the other.
template <class Inside, class Outside>
struct Number {
    float Inside::*inside;
    double Outside::*outside;
};
template <class Inside, class Outside>
struct Vector {
    glm::vec3 Inside::*inside;
    double (Outside::*outside)[3];
};

constexpr Number<Environment, rubble_environment> kEnvironmentScalars[] = {
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
constexpr Number<Light, rubble_light_state> kLightScalars[] = {
    {&Light::radius, &rubble_light_state::radius},        {&Light::reach, &rubble_light_state::reach},
    {&Light::coneInner, &rubble_light_state::cone_inner}, {&Light::coneOuter, &rubble_light_state::cone_outer},
    {&Light::width, &rubble_light_state::width},          {&Light::height, &rubble_light_state::height},
};
constexpr Vector<Light, rubble_light_state> kLightVectors[] = {
    {&Light::color, &rubble_light_state::color},
};

/// What a float cannot hold becomes one that no range has.
float toFloat(double value) {
    return float(std::clamp(value, -1e30, 1e30));
}
template <class Inside, class Outside>
void read(const Number<Inside, Outside>& number, const Outside& from, Inside& to) {
    to.*number.inside = toFloat(from.*number.outside);
}
template <class Inside, class Outside>
void read(const Vector<Inside, Outside>& vector, const Outside& from, Inside& to) {
    for (int i = 0; i < 3; ++i) (to.*vector.inside)[i] = toFloat((from.*vector.outside)[i]);
}
template <class Inside, class Outside>
void write(const Number<Inside, Outside>& number, const Inside& from, Outside& to) {
    to.*number.outside = double(from.*number.inside);
}
template <class Inside, class Outside>
void write(const Vector<Inside, Outside>& vector, const Inside& from, Outside& to) {
    writeVector(to.*vector.outside, glm::dvec3(from.*vector.inside));
}

Environment readEnvironment(const rubble_environment& given) {
    Environment out;
    for (const auto& number : kEnvironmentScalars) read(number, given, out);
    for (const auto& vector : kEnvironmentVectors) read(vector, given, out);
    requireNoError(environmentError(out));
    return out;
}

rubble_environment toHost(const Environment& from) {
    rubble_environment out = {};
    for (const auto& number : kEnvironmentScalars) write(number, from, out);
    for (const auto& vector : kEnvironmentVectors) write(vector, from, out);
    return out;
}

const Light& lightOf(const World& world, rubble_light bits) {
    const LightHandle handle = readHandle<HandleType::Light>(bits, "light");
    requireAlive(world.lights(), handle, "light");
    return world.lights().at(handle);
}

rubble_light_state toHost(LightHandle handle, const Light& from) {
    rubble_light_state out = {};
    for (const auto& number : kLightScalars) write(number, from, out);
    for (const auto& vector : kLightVectors) write(vector, from, out);
    out.light = handle.bits;
    out.kind = uint32_t(from.kind);
    out.flags = (from.enabled ? RUBBLE_LIGHT_ENABLED : 0) | (from.twoSided ? RUBBLE_LIGHT_TWO_SIDED : 0);
    out.shape = from.shape.bits;
    out.group = from.group.bits;
    writeVector(out.position, from.local.position);
    writeRotation(out.rotation, from.local.rotation);
    return out;
}

/// Its handle must name something, or be 0.
template <HandleType kType, class Map>
Handle<kType> readOptionalHandle(const Map& map, uint64_t bits, const char* name) {
    const Handle<kType> handle = readHandle<kType>(bits, name);
    if (handle) requireAlive(map, handle, name);
    return handle;
}

/// `light`: what the host cannot say stays as it is there.
Light readLight(const World& world, const rubble_light_state& given, Light light) {
    if (given.flags & ~uint32_t(RUBBLE_LIGHT_ENABLED | RUBBLE_LIGHT_TWO_SIDED))
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "flags has unknown bits"};
    for (const auto& number : kLightScalars) read(number, given, light);
    for (const auto& vector : kLightVectors) read(vector, given, light);
    light.kind = LightKind(std::min(given.kind, 255u));
    light.shape = readOptionalHandle<HandleType::Shape>(world.shapes(), given.shape, "shape");
    light.group = readOptionalHandle<HandleType::LightGroup>(world.lightGroups(), given.group, "group");
    light.local = {readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    light.enabled = given.flags & RUBBLE_LIGHT_ENABLED;
    light.twoSided = given.flags & RUBBLE_LIGHT_TWO_SIDED;
    requireNoError(lightError(light));
    return light;
}

}  // namespace

rubble_result environment(rubble_world world, rubble_environment* out) {
    return guarded("get_environment",
                   [&] { writeStruct(out, toHost(Registry::instance().world(world)->loop.world().environment())); });
}

rubble_result setEnvironment(rubble_world world, const rubble_environment* environment) {
    return pushEdit("set_environment", world, environment, [](const World&, const rubble_environment& given) {
        return SetEnvironmentEdit{readEnvironment(given)};
    });
}

rubble_result applySkyModel(rubble_environment* environment, const double* toSun) {
    return guarded("compute_sky", [&] {
        Environment now = readEnvironment(readStruct(environment, "get_environment"));
        const glm::dvec3 direction =
            readVector(reinterpret_cast<const double(&)[3]>(requireNotNull(toSun, "to_sun")), "to_sun");
        if (!(glm::length(direction) > 1e-6)) throw ApiError{RUBBLE_ERROR_ARGUMENT, "to_sun is zero"};
        rubble::applySkyModel(now, glm::vec3(direction));
        writeStruct(environment, toHost(now));
    });
}

rubble_result lights(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count) {
    return listAll("get_lights", world, out, capacity, count, &World::lights);
}

rubble_result lightState(rubble_world world, rubble_light light, rubble_light_state* out) {
    return guarded("get_light_state", [&] {
        const auto hosted = Registry::instance().world(world);
        writeStruct(out, toHost(LightHandle{light}, lightOf(hosted->loop.world(), light)));
    });
}

rubble_result setLight(rubble_world world, const rubble_light_state* light) {
    return pushEdit("set_light", world, light, [](const World& in, const rubble_light_state& given) {
        return SetLightEdit{LightHandle{given.light}, readLight(in, given, lightOf(in, given.light))};
    });
}

rubble_result addLight(rubble_world world, const rubble_light_state* light) {
    return pushEdit("add_light", world, light, [](const World& in, const rubble_light_state& given) {
        return AddLightEdit{readLight(in, given, {})};
    });
}

rubble_result removeLight(rubble_world world, rubble_light light) {
    return removeOne<RemoveLightEdit, HandleType::Light>("remove_light", world, light, "light", &World::lights);
}

rubble_result getAddedLights(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count) {
    return guarded("get_added_lights", [&] {
        const auto hosted = Registry::instance().world(world);
        RowWriter<rubble_light> rows(out, capacity, count);
        for (const LightHandle light : hosted->loop.changes().lightsAdded) rows.add([&] { return light.bits; });
        rows.finish();
    });
}

}  // namespace rubble::abi
