#include "runtime/world/objects/lights.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "runtime/core/hash.h"
#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"

namespace rubble {
namespace {

/// A number, or three, of a T and their range.
template <class T, class Value>
struct NumberField {
    const char* name;  ///< as in files and in rubble.h
    Value T::*value;
    NumberRange range;
};

constexpr NumberField<Light, float> kLightNumbers[] = {
    {"radius", &Light::radius, ranges::kLightSize},        {"reach", &Light::reach, ranges::kLightReach},
    {"cone_inner", &Light::coneInner, ranges::kConeAngle}, {"cone_outer", &Light::coneOuter, ranges::kConeAngle},
    {"width", &Light::width, ranges::kLightSize},          {"height", &Light::height, ranges::kLightSize},
};
constexpr NumberField<Light, glm::vec3> kLightVectors[] = {{"color", &Light::color, ranges::kColor}};
constexpr NumberField<Environment, float> kEnvironmentNumbers[] = {
    {"sun_angle", &Environment::sunAngle, ranges::kSunAngle},
    {"fog_distance", &Environment::fogDistance, ranges::kFogDistance},
    {"fog_density", &Environment::fogDensity, ranges::kFogDensity},
    {"fog_base", &Environment::fogBase, ranges::kFogBase},
    {"fog_height", &Environment::fogHeight, ranges::kFogHeight},
    {"fog_forward", &Environment::fogForward, ranges::kFogForward},
    {"clouds", &Environment::clouds, ranges::kShare},
    {"stars", &Environment::stars, ranges::kBrightness},
    {"exposure", &Environment::exposure, ranges::kBrightness},
    {"wetness", &Environment::wetness, ranges::kShare},
};
constexpr NumberField<Environment, glm::vec3> kEnvironmentVectors[] = {
    {"sun_direction", &Environment::sunDirection, ranges::kDirection},
    {"sun_color", &Environment::sunColor, ranges::kColor},
    {"sky_color", &Environment::skyColor, ranges::kColor},
    {"horizon_color", &Environment::horizonColor, ranges::kColor},
    {"ground_color", &Environment::groundColor, ranges::kColor},
    {"fog_color", &Environment::fogColor, ranges::kColor},
    {"fog_tint", &Environment::fogTint, ranges::kColor},
    {"gravity", &Environment::gravity, ranges::kGravity},
};

template <class T, size_t kNumbers, size_t kVectors>
RangeCheck checkFields(const T& value, const NumberField<T, float> (&numbers)[kNumbers],
                       const NumberField<T, glm::vec3> (&vectors)[kVectors]) {
    RangeCheck check;
    for (const auto& [name, number, range] : numbers) check.number(name, double(value.*number), range);
    for (const auto& [name, vector, range] : vectors) check.vector(name, value.*vector, range);
    return check;
}

template <class T, size_t kNumbers, size_t kVectors>
uint64_t hashRanges(const T& value, const NumberField<T, float> (&numbers)[kNumbers],
                    const NumberField<T, glm::vec3> (&vectors)[kVectors]) {
    uint64_t hash = 0;
    for (const auto& field : numbers) hash = hashValue(value.*field.value, hash);
    for (const auto& field : vectors) hash = hashBytes(&(value.*field.value), sizeof(glm::vec3), hash);
    return hash;
}

}  // namespace

std::string lightError(const Light& light) {
    RangeCheck check;
    check.vector("position", light.local.position, ranges::kPlace)
        .rotation("its rotation", light.local.rotation)
        .text("name", light.name)
        .number("kind", double(light.kind), {0.0, double(LightKind::Screen)})
        .include(checkFields(light, kLightNumbers, kLightVectors).error());
    if (!check.error().empty() || light.image.isWhole()) return check.error();
    return "its image has " + std::to_string(light.image.texels.size()) + " texels in rows of " +
           std::to_string(light.image.width) + ", expected whole rows and at most " +
           std::to_string(kMaxLightImageSide) + " texels a side";
}

void clampToRanges(Light& light) {
    const auto clamp = [](float value, NumberRange range) {
        return float(std::clamp(double(value), range.low, range.high));
    };
    for (const auto& [name, number, range] : kLightNumbers) light.*number = clamp(light.*number, range);
    for (const auto& [name, vector, range] : kLightVectors)
        for (int i = 0; i < 3; ++i) (light.*vector)[i] = clamp((light.*vector)[i], range);
}

uint64_t Light::hash() const {
    uint64_t hash = hashRanges(*this, kLightNumbers, kLightVectors);
    hash = hashBytes(&local.position, sizeof local.position, hash);
    hash = hashBytes(&local.rotation, sizeof local.rotation, hash);
    hash = hashBytes(image.texels.data(), image.texels.size() * sizeof(uint32_t), hashValue(image.width, hash));
    hash = hashValue(group ? group.slot() + 1 : 0, hashValue(shape ? shape.slot() + 1 : 0, hash));
    return hashValue(uint32_t(kind) << 8 | uint32_t(twoSided) << 1 | uint32_t(enabled), hash);
}

std::string environmentError(const Environment& environment) {
    return checkFields(environment, kEnvironmentNumbers, kEnvironmentVectors)
        .require(glm::length(environment.sunDirection) > 1e-6f, "sun_direction is zero, expected a direction")
        .error();
}

uint64_t Environment::hash() const {
    return hashRanges(*this, kEnvironmentNumbers, kEnvironmentVectors);
}

}  // namespace rubble
