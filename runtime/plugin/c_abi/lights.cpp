#include "runtime/plugin/c_abi/lights.h"

#include "runtime/plugin/c_abi/guard.h"
#include "runtime/world/sky_model.h"

namespace rubble::abi {
namespace {

/// Where a number of one struct is in the other, and what it may be.
template <class Inside, class Outside>
struct Number {
    const char* name;
    float Inside::*inside;
    double Outside::*outside;
    double low, high;
};
template <class Inside, class Outside>
struct Vector {
    const char* name;
    glm::vec3 Inside::*inside;
    double (Outside::*outside)[3];
    double low, high;
};

constexpr double kMost = 1e6;

constexpr Number<Environment, rubble_environment> kEnvironmentNumbers[] = {
    {"sun_angle", &Environment::sunAngle, &rubble_environment::sun_angle, 0.0, 1.5},
    {"fog_distance", &Environment::fogDistance, &rubble_environment::fog_distance, 1e-3, 1e9},
    {"fog_density", &Environment::fogDensity, &rubble_environment::fog_density, 0.0, kMost},
    {"fog_base", &Environment::fogBase, &rubble_environment::fog_base, -kMost, kMost},
    {"fog_height", &Environment::fogHeight, &rubble_environment::fog_height, 1e-3, kMost},
    {"fog_forward", &Environment::fogForward, &rubble_environment::fog_forward, -0.9, 0.9},
    {"clouds", &Environment::clouds, &rubble_environment::clouds, 0.0, 1.0},
    {"stars", &Environment::stars, &rubble_environment::stars, 0.0, kMost},
    {"exposure", &Environment::exposure, &rubble_environment::exposure, 0.0, kMost},
    {"wetness", &Environment::wetness, &rubble_environment::wetness, 0.0, 1.0},
};
constexpr Vector<Environment, rubble_environment> kEnvironmentVectors[] = {
    {"sun_direction", &Environment::sunDirection, &rubble_environment::sun_direction, -kMost, kMost},
    {"sun_color", &Environment::sunColor, &rubble_environment::sun_color, 0.0, kMost},
    {"sky_color", &Environment::skyColor, &rubble_environment::sky_color, 0.0, kMost},
    {"horizon_color", &Environment::horizonColor, &rubble_environment::horizon_color, 0.0, kMost},
    {"ground_color", &Environment::groundColor, &rubble_environment::ground_color, 0.0, kMost},
    {"fog_color", &Environment::fogColor, &rubble_environment::fog_color, 0.0, kMost},
    {"fog_tint", &Environment::fogTint, &rubble_environment::fog_tint, 0.0, kMost},
    {"gravity", &Environment::gravity, &rubble_environment::gravity, -1e3, 1e3},
};
constexpr Number<SetLightEdit, rubble_light_state> kLightNumbers[] = {
    {"radius", &SetLightEdit::radius, &rubble_light_state::radius, 0.0, 1e3},
    {"reach", &SetLightEdit::reach, &rubble_light_state::reach, 0.0, 1e5},
    {"cone_inner", &SetLightEdit::coneInner, &rubble_light_state::cone_inner, 0.0, 3.15},
    {"cone_outer", &SetLightEdit::coneOuter, &rubble_light_state::cone_outer, 0.0, 3.15},
    {"width", &SetLightEdit::width, &rubble_light_state::width, 0.0, 1e3},
    {"height", &SetLightEdit::height, &rubble_light_state::height, 0.0, 1e3},
};
constexpr Vector<SetLightEdit, rubble_light_state> kLightVectors[] = {
    {"color", &SetLightEdit::color, &rubble_light_state::color, 0.0, kMost},
};

template <class Inside, class Outside>
void read(const Number<Inside, Outside>& number, const Outside& from, Inside& to) {
    to.*number.inside = float(readLiteral(from.*number.outside, number.low, number.high, number.name));
}
template <class Inside, class Outside>
void read(const Vector<Inside, Outside>& vector, const Outside& from, Inside& to) {
    for (int i = 0; i < 3; ++i)
        (to.*vector.inside)[i] =
            float(readLiteral((from.*vector.outside)[i], vector.low, vector.high, std::string(vector.name) + "[" + std::to_string(i) + "]"));
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
    for (const auto& number : kEnvironmentNumbers) read(number, given, out);
    for (const auto& vector : kEnvironmentVectors) read(vector, given, out);
    if (!(glm::length(out.sunDirection) > 1e-6f)) throw Refusal{RUBBLE_ERROR_ARGUMENT, "sun_direction is zero"};
    return out;
}

rubble_environment toHost(const Environment& from) {
    rubble_environment out = {};
    for (const auto& number : kEnvironmentNumbers) write(number, from, out);
    for (const auto& vector : kEnvironmentVectors) write(vector, from, out);
    return out;
}

const Light& lightOf(const World& world, rubble_light bits) {
    const LightHandle handle = readHandle<HandleType::Light>(bits, "light");
    demandThere(world.lights(), handle, "light");
    return world.lights().at(handle);
}

rubble_light_state toHost(LightHandle handle, const Light& from) {
    rubble_light_state out = {};
    const SetLightEdit now(handle, from);
    for (const auto& number : kLightNumbers) write(number, now, out);
    for (const auto& vector : kLightVectors) write(vector, now, out);
    out.light = handle.bits;
    out.kind = uint32_t(from.kind);
    out.flags = (from.enabled ? RUBBLE_LIGHT_ENABLED : 0) | (from.twoSided ? RUBBLE_LIGHT_TWO_SIDED : 0);
    out.shape = from.shape.bits;
    out.group = from.group.bits;
    writeVector(out.position, from.local.position);
    writeRotation(out.rotation, from.local.rotation);
    return out;
}

SetLightEdit toEdit(const World& world, const rubble_light_state& given) {
    if (given.flags & ~uint32_t(RUBBLE_LIGHT_ENABLED | RUBBLE_LIGHT_TWO_SIDED)) throw Refusal{RUBBLE_ERROR_ARGUMENT, "flags has unknown bits"};
    SetLightEdit edit(LightHandle{given.light}, lightOf(world, given.light));
    for (const auto& number : kLightNumbers) read(number, given, edit);
    for (const auto& vector : kLightVectors) read(vector, given, edit);
    edit.local = {readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    edit.enabled = given.flags & RUBBLE_LIGHT_ENABLED;
    edit.twoSided = given.flags & RUBBLE_LIGHT_TWO_SIDED;
    return edit;
}

}  // namespace

rubble_result environment(rubble_world world, rubble_environment* out) {
    return guarded("environment", [&] { writeTo(out, toHost(Registry::instance().world(world)->loop.world().environment())); });
}

rubble_result setEnvironment(rubble_world world, const rubble_environment* environment) {
    return pushEdit("set_environment", world, environment,
                    [](const World&, const rubble_environment& given) { return SetEnvironmentEdit{readEnvironment(given)}; });
}

rubble_result followSun(rubble_environment* environment, const double* toSun) {
    return guarded("follow_sun", [&] {
        Environment now = readEnvironment(readable(environment, "environment"));
        const glm::dvec3 direction = readVector(reinterpret_cast<const double(&)[3]>(required(toSun, "to_sun")), "to_sun");
        if (!(glm::length(direction) > 1e-6)) throw Refusal{RUBBLE_ERROR_ARGUMENT, "to_sun is zero"};
        rubble::followSun(now, glm::vec3(direction));
        writeTo(environment, toHost(now));
    });
}

rubble_result lights(rubble_world world, rubble_light* out, uint32_t capacity, uint32_t* count) {
    return listAll("lights", world, out, capacity, count, &World::lights);
}

rubble_result lightState(rubble_world world, rubble_light light, rubble_light_state* out) {
    return guarded("light_state", [&] {
        const auto hosted = Registry::instance().world(world);
        writeTo(out, toHost(LightHandle{light}, lightOf(hosted->loop.world(), light)));
    });
}

rubble_result setLight(rubble_world world, const rubble_light_state* light) {
    return pushEdit("set_light", world, light, [](const World& in, const rubble_light_state& given) { return toEdit(in, given); });
}

}  // namespace rubble::abi
