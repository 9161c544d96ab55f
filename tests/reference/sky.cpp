#include "tests/reference/sky.h"

#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace rubble::reference {
namespace {

using glm::clamp;
using glm::mix;
using glm::smoothstep;
using glm::vec2;
using glm::vec3;

uint32_t hashBits(uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

float hash01(glm::ivec2 p) {
    return float(hashBits(uint32_t(p.x) + hashBits(uint32_t(p.y))) >> 8) * (1.0f / 16777216.0f);
}

float valueNoise(vec2 p) {
    const vec2 cell = glm::floor(p);
    vec2 f = p - cell;
    f = f * f * (3.0f - 2.0f * f);
    const glm::ivec2 i(cell);
    const float low = mix(hash01(i), hash01(i + glm::ivec2(1, 0)), f.x);
    const float high = mix(hash01(i + glm::ivec2(0, 1)), hash01(i + glm::ivec2(1, 1)), f.x);
    return mix(low, high, f.y);
}

float fractalNoise(vec2 p, int octaves) {
    float sum = 0.0f, weight = 0.5f, total = 0.0f;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * valueNoise(p);
        total += weight;
        weight *= 0.5f;
        p = glm::mat2(1.62f, 1.18f, -1.18f, 1.62f) * p + 17.3f;
    }
    return sum / total;
}

vec2 horizontal(vec3 v) {
    return {v.x, v.z};
}

vec3 toSun(const Environment& air) {
    return glm::normalize(air.sunDirection);
}

vec3 sunGlow(const Environment& air, float mu) {
    const float m = std::max(mu, 0.0f), m2 = m * m, m8 = m2 * m2 * m2 * m2, m32 = m8 * m8 * m8 * m8,
                m256 = std::pow(m32, 8.0f);
    return air.sunColor * (0.012f * m2 + 0.035f * m8 + 0.10f * m32 + 0.45f * m256);
}

vec3 withClouds(const Environment& air, vec3 sky, vec3 direction) {
    const float height = direction.y + 0.06f;
    if (height < 0.07f) return sky;
    const vec2 place = horizontal(direction) / height * 1.3f + 40.0f;
    const vec2 stretched = place * vec2(0.75f, 1.25f);
    const float density = fractalNoise(stretched, 6) * 0.75f + valueNoise(stretched * 0.35f + 9.1f) * 0.35f;
    const float more = (air.clouds - 0.5f) * 0.9f;
    const float cover = smoothstep(0.52f - more, 0.80f - more, density);
    if (cover <= 0.0f) return sky;
    const vec2 aside = glm::normalize(horizontal(toSun(air))) * 0.35f;
    const float thickness =
        fractalNoise(stretched + aside, 4) * 0.75f + valueNoise((stretched + aside) * 0.35f + 9.1f) * 0.35f;
    const float lit = clamp(1.0f - (thickness - 0.45f) * 2.6f, 0.0f, 1.0f);
    const float mu = std::max(glm::dot(direction, toSun(air)), 0.0f);
    const vec3 shade = mix(air.skyColor, air.horizonColor, 0.55f) * 0.75f;
    const vec3 bright = air.sunColor * (0.13f + 0.16f * std::pow(mu, 6.0f)) + air.skyColor * 0.35f;
    return mix(sky, mix(shade, bright, lit), cover * 0.85f * smoothstep(0.07f, 0.30f, height));
}

float landscapeMetres(const Environment& air, float metres) {
    return metres * std::max(1.0f, air.fogDistance / 150.0f);
}

vec3 withHills(const Environment& air, vec3 sky, vec3 direction) {
    const vec2 heading = glm::normalize(horizontal(direction));
    const float slope = direction.y / std::max(glm::length(horizontal(direction)), 1e-4f);
    if (slope > 0.16f) return sky;
    const vec3 haze = hazeRadiance(air, direction);
    const vec3 light = air.sunColor * 0.06f + air.skyColor * 0.35f;
    const auto edge = [&](float line) { return clamp(0.5f + (line - slope) / 0.0044f, 0.0f, 1.0f); };
    const auto smooth = [](float t) { return t * t * (3.0f - 2.0f * t); };
    const float far = 0.035f + 0.085f * fractalNoise(heading * 3.1f + 11.0f, 4);
    sky = mix(sky, mix(vec3(0.16f, 0.20f, 0.24f) * light, haze, hazeAmount(air, landscapeMetres(air, 300.0f))),
              smooth(edge(far)));
    const float middle = 0.015f + 0.060f * fractalNoise(heading * 5.7f + 47.0f, 5);
    sky = mix(sky, mix(vec3(0.14f, 0.20f, 0.13f) * light, haze, hazeAmount(air, landscapeMetres(air, 234.0f))),
              smooth(edge(middle)));
    const float woods =
        0.004f + 0.024f * fractalNoise(heading * 9.0f + 83.0f, 3) + 0.010f * fractalNoise(heading * 140.0f + 5.0f, 3);
    const float shading = 0.75f + 0.5f * valueNoise(vec2(std::atan2(heading.y, heading.x) * 160.0f, slope * 500.0f));
    return mix(sky,
               mix(vec3(0.13f, 0.18f, 0.08f) * light * shading, haze, hazeAmount(air, landscapeMetres(air, 181.0f))),
               smooth(edge(woods)));
}

/// As in lib/sky.glsl.
vec3 throughHaze(const Environment& air, vec3 background, vec3 direction) {
    return mix(hazeRadiance(air, direction), background,
               smoothstep(5.0f, mix(100.0f, 40.0f, smoothstep(0.0f, 0.3f, direction.y)), air.fogDistance));
}

vec3 fieldsBelow(const Environment& air, vec3 direction, vec3 eye, float eyeHeight) {
    const float distanceMetres = eyeHeight / std::max(-direction.y, 1e-4f);
    const vec2 place = horizontal(direction) * distanceMetres + horizontal(eye);
    const float detail = std::exp2(-distanceMetres * 0.02f);
    const float patches = fractalNoise(place * 0.02f, 3);
    const float tufts = mix(0.5f, fractalNoise(place * 0.9f, 3), detail);
    const vec3 albedo =
        mix(vec3(0.115f, 0.155f, 0.055f), vec3(0.22f, 0.20f, 0.085f), smoothstep(0.35f, 0.7f, patches)) *
        (0.75f + 0.5f * tufts);
    const vec3 light = air.sunColor * std::max(toSun(air).y, 0.0f) * 0.3183f + skyRadiance(air, vec3(0, 1, 0)) * 0.8f;
    const vec3 haze = hazeRadiance(air, direction);
    return throughHaze(
        air, mix(albedo * light, haze, hazeAmount(air, std::min(distanceMetres, landscapeMetres(air, 225.0f)))),
        direction);
}

}  // namespace

vec3 skyRadiance(const Environment& air, vec3 direction) {
    const float mu = glm::dot(direction, toSun(air));
    const float up = std::max(direction.y, 0.0f);
    vec3 sky = mix(air.horizonColor, air.skyColor, 1.0f - std::pow(1.0f - std::min(up, 1.0f), 4.0f));
    sky += sunGlow(air, mu) * (1.0f - 0.6f * up);
    return mix(air.groundColor, sky, smoothstep(-0.06f, 0.02f, direction.y));
}

vec3 mirroredBackground(const Environment& air, vec3 direction, vec3 eye, float eyeHeight) {
    if (direction.y < 0.0f && eyeHeight > 0.0f) return fieldsBelow(air, direction, eye, eyeHeight);
    const vec3 sky = skyRadiance(air, direction);
    return throughHaze(air, direction.y > 0.0f ? withHills(air, withClouds(air, sky, direction), direction) : sky,
                       direction);
}

vec3 hazeRadiance(const Environment& air, vec3 direction) {
    return air.fogColor + sunGlow(air, glm::dot(direction, toSun(air))) * 0.5f;
}

float hazeAmount(const Environment& air, float distanceMetres) {
    const float ratio = distanceMetres / air.fogDistance;
    return 1.0f - std::exp2(-ratio * std::sqrt(ratio));
}

vec3 backgroundRadiance(const Environment& air, vec3 direction, vec3 eye, float eyeHeight) {
    if (direction.y < 0.0f && eyeHeight > 0.0f) return fieldsBelow(air, direction, eye, eyeHeight);
    const float mu = glm::dot(direction, toSun(air));
    vec3 sky =
        withClouds(air, skyRadiance(air, vec3(direction.x, std::max(direction.y, 0.02f), direction.z)), direction);
    const float edge = 1.0f - 0.5f * air.sunAngle * air.sunAngle * 4.0f;
    sky += air.sunColor * 12.0f * smoothstep(edge, 1.0f - (1.0f - edge) * 0.6f, mu) *
           (1.0f - smoothstep(0.6f, 0.95f, air.clouds));
    return throughHaze(air, withHills(air, sky, direction), direction);
}

}  // namespace rubble::reference
