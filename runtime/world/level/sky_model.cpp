#include "runtime/world/level/sky_model.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "runtime/core/constants.h"

namespace rubble {
namespace {

// A clear sky as a single-scattering fit: light that crosses an optical depth d of air is multiplied by exp(-d), and
// the depth is that of the whole atmosphere, straight up, times the air mass of the direction. Molecules scatter blue
// most (Rayleigh), which colours the sky and reddens a low sun. Constants are for red, green and blue, fitted so that
// an afternoon looks as the scenes set it by hand.
constexpr glm::dvec3 kSolarIrradiance{17.2, 15.7, 15.4};   ///< above the atmosphere, in the renderer's units
constexpr glm::dvec3 kOpticalDepth{0.15, 0.22, 0.37};      ///< of the whole atmosphere: molecules and dust
constexpr glm::dvec3 kRayleighDepth{0.05, 0.11, 0.25};     ///< of its molecules
constexpr glm::dvec3 kOzoneTwilight{0.012, 0.040, 0.120};  ///< radiance overhead at twilight, after absorption by ozone
constexpr glm::vec3 kMoonDirection{-0.55f, 0.52f, 0.40f};
constexpr glm::dvec3 kMoonIrradiance{0.15, 0.19, 0.28};  ///< brighter than the real moon, as in films
constexpr glm::dvec3 kNightSky{0.010, 0.017, 0.040}, kNightHorizon{0.026, 0.030, 0.046};

/// exp(-x) by multiplications alone: (1 - x / 4096)^4096, the same on every machine.
double expDecay(double x) {
    double power = std::max(1.0 - x / 4096.0, 0.0);
    for (int i = 0; i < 12; ++i) power *= power;
    return power;
}

/// Share of light that is left after a multiple of the vertical atmosphere.
glm::dvec3 transmittance(double amount) {
    return {expDecay(kOpticalDepth.r * amount), expDecay(kOpticalDepth.g * amount), expDecay(kOpticalDepth.b * amount)};
}

double smoothStep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Air along a direction as a multiple of that straight up, from the sine of its elevation (Rozenberg 1966):
/// 1 / (s + 0.025 exp(-11 s)).
double airMass(double sine) {
    const double up = std::max(sine, 0.0);
    return 1.0 / (up + 0.025 * expDecay(11.0 * up));
}

struct Colors {
    glm::dvec3 sun, sky, horizon;
};

Colors clearColors(double sine) {
    // The sky overhead is lit high up, where the light of a low sun has crossed less air than at the ground.
    const double sunAirMass = airMass(sine), skyAirMass = std::min(sunAirMass, 7.0);
    // The disc is gone at 1.5 degrees below the horizon, twilight at 9.
    const double day = smoothStep(-0.16, 0.20, sine), sunVisible = smoothStep(-0.026, 0.02, sine);
    Colors colors;
    colors.sun = kSolarIrradiance * transmittance(sunAirMass) * sunVisible;
    colors.sky = kSolarIrradiance * kRayleighDepth * transmittance(0.4 * skyAirMass) * (0.31 * day) +
                 kOzoneTwilight * smoothStep(-0.20, 0.0, sine) * (1.0 - smoothStep(0.1, 0.4, sine));
    colors.horizon = kSolarIrradiance * transmittance(0.5 * skyAirMass) * (0.054 * day);
    const double night = 1.0 - smoothStep(-0.20, 0.0, sine);
    colors.sky += kNightSky * night;
    colors.horizon += kNightHorizon * night;
    return colors;
}

/// Clouds scatter the light: the sun fades, and the sky turns grey, a little brighter overhead than around.
void addClouds(Colors& colors, double cover, double sine) {
    const glm::dvec3 falling = colors.sun * std::max(sine, 0.0) / kPi + 0.7 * colors.sky + 0.3 * colors.horizon;
    const double light = 0.34 * (0.25 * falling.r + 0.6 * falling.g + 0.15 * falling.b);
    const glm::dvec3 grey = glm::dvec3(0.92, 0.98, 1.08) * light;
    colors.sun *= (1.0 - cover) * (1.0 - cover);
    colors.sky = glm::mix(colors.sky, grey, cover);
    colors.horizon = glm::mix(colors.horizon, grey * 0.85, cover);
}

}  // namespace

void applySkyModel(Environment& environment, glm::vec3 sunDirection) {
    const float length = glm::length(sunDirection);
    const glm::vec3 sun = length > 0.0f ? sunDirection / length : glm::vec3(0, 1, 0);
    const double sine = double(sun.y);
    Colors colors = clearColors(sine);
    const bool moonlit = sine < -0.05;
    if (moonlit) colors.sun = kMoonIrradiance * smoothStep(0.05, 0.20, -sine);
    const glm::vec3 lightDirection = moonlit ? glm::normalize(kMoonDirection) : sun;
    addClouds(colors, smoothStep(0.5, 1.0, double(environment.clouds)), double(lightDirection.y));
    environment.sunDirection = lightDirection;
    environment.sunColor = colors.sun;
    environment.skyColor = colors.sky;
    environment.horizonColor = colors.horizon;
    environment.groundColor =
        colors.sun * (0.041 * std::max(double(lightDirection.y), 0.0)) + 0.10 * colors.sky + 0.06 * colors.horizon;
    environment.fogColor = glm::mix(colors.sky, colors.horizon, 0.45);
    environment.stars = float(smoothStep(0.03, 0.20, -sine) * (1.0 - smoothStep(0.5, 0.9, double(environment.clouds))));
}

}  // namespace rubble
