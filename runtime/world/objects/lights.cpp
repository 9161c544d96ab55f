#include "runtime/world/objects/lights.h"

#include <cstdio>
#include <glm/geometric.hpp>

#include "runtime/core/hash.h"
#include "runtime/core/number_range.h"

namespace rubble {
namespace {

/// The valid range of a number, or of three, of a T.
template <class T, class Value>
struct NumberRange {
    const char* name;  ///< as in files and in rubble.h
    Value T::*value;
    float low, high;
};

constexpr float kMaxValue = 1e6f;

constexpr NumberRange<Light, float> kLightNumbers[] = {
    {"radius", &Light::radius, 0.0f, 1e3f},         {"reach", &Light::reach, 0.0f, 1e5f},
    {"cone_inner", &Light::coneInner, 0.0f, 3.15f}, {"cone_outer", &Light::coneOuter, 0.0f, 3.15f},
    {"width", &Light::width, 0.0f, 1e3f},           {"height", &Light::height, 0.0f, 1e3f},
};
constexpr NumberRange<Light, glm::vec3> kLightVectors[] = {{"color", &Light::color, 0.0f, kMaxValue}};
constexpr NumberRange<Environment, float> kEnvironmentNumbers[] = {
    {"sun_angle", &Environment::sunAngle, 0.0f, 1.5f},
    {"fog_distance", &Environment::fogDistance, 1e-3f, 1e9f},
    {"fog_density", &Environment::fogDensity, 0.0f, kMaxValue},
    {"fog_base", &Environment::fogBase, -kMaxValue, kMaxValue},
    {"fog_height", &Environment::fogHeight, 1e-3f, kMaxValue},
    {"fog_forward", &Environment::fogForward, -0.9f, 0.9f},
    {"clouds", &Environment::clouds, 0.0f, 1.0f},
    {"stars", &Environment::stars, 0.0f, kMaxValue},
    {"exposure", &Environment::exposure, 0.0f, kMaxValue},
    {"wetness", &Environment::wetness, 0.0f, 1.0f},
};
constexpr NumberRange<Environment, glm::vec3> kEnvironmentVectors[] = {
    {"sun_direction", &Environment::sunDirection, -kMaxValue, kMaxValue},
    {"sun_color", &Environment::sunColor, 0.0f, kMaxValue},
    {"sky_color", &Environment::skyColor, 0.0f, kMaxValue},
    {"horizon_color", &Environment::horizonColor, 0.0f, kMaxValue},
    {"ground_color", &Environment::groundColor, 0.0f, kMaxValue},
    {"fog_color", &Environment::fogColor, 0.0f, kMaxValue},
    {"fog_tint", &Environment::fogTint, 0.0f, kMaxValue},
    {"gravity", &Environment::gravity, -1e3f, 1e3f},
};

std::string numberError(const std::string& name, double value, double low, double high) {
    if (isWithin(value, low, high)) return "";
    char text[80];
    std::snprintf(text, sizeof text, " is %g, expected %g to %g", value, low, high);
    return name + text;
}

/// About the first number that is out of its range; empty: none.
template <class T, size_t kNumbers, size_t kVectors>
std::string rangeError(const T& value, const NumberRange<T, float> (&numbers)[kNumbers],
                       const NumberRange<T, glm::vec3> (&vectors)[kVectors]) {
    for (const auto& [name, number, low, high] : numbers)
        if (std::string error = numberError(name, value.*number, low, high); !error.empty()) return error;
    for (const auto& [name, vector, low, high] : vectors)
        for (int i = 0; i < 3; ++i)
            if (std::string error = numberError(name + ("[" + std::to_string(i) + "]"), (value.*vector)[i], low, high);
                !error.empty())
                return error;
    return "";
}

template <class T, size_t kNumbers, size_t kVectors>
uint64_t hashRanges(const T& value, const NumberRange<T, float> (&numbers)[kNumbers],
                    const NumberRange<T, glm::vec3> (&vectors)[kVectors]) {
    uint64_t hash = 0;
    for (const auto& range : numbers) hash = hashValue(value.*range.value, hash);
    for (const auto& range : vectors) hash = hashBytes(&(value.*range.value), sizeof(glm::vec3), hash);
    return hash;
}

}  // namespace

std::string lightError(const Light& light) {
    constexpr double kMaxCoordinate = 1e9;
    const glm::dquat& q = light.local.rotation;
    for (int i = 0; i < 3; ++i)
        if (std::string error = numberError("position[" + std::to_string(i) + "]", light.local.position[i],
                                            -kMaxCoordinate, kMaxCoordinate);
            !error.empty())
            return error;
    if (std::string error = numberError("the squared length of its rotation", glm::dot(q, q), 0.998, 1.002);
        !error.empty())
        return error;
    if (std::string error = numberError("kind", double(light.kind), 0.0, double(LightKind::Screen)); !error.empty())
        return error;
    if (!light.image.isWhole())
        return "its image has " + std::to_string(light.image.texels.size()) + " texels in rows of " +
               std::to_string(light.image.width) + ", expected whole rows and at most " +
               std::to_string(kMaxLightImageSide) + " texels a side";
    return rangeError(light, kLightNumbers, kLightVectors);
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
    if (std::string error = rangeError(environment, kEnvironmentNumbers, kEnvironmentVectors); !error.empty())
        return error;
    return glm::length(environment.sunDirection) > 1e-6f ? "" : "sun_direction is zero, expected a direction";
}

uint64_t Environment::hash() const {
    return hashRanges(*this, kEnvironmentNumbers, kEnvironmentVectors);
}

}  // namespace rubble
