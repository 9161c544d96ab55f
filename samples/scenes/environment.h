#pragma once
#include <string_view>

#include "runtime/world/level/sky_model.h"

namespace rubble::scenes {

/// A low sun from the left, a clear cool sky, a little haze.
inline Environment lateAfternoon() {
    Environment air;
    air.sunDirection = {-0.90f, 0.36f, -0.05f};
    air.sunColor = {11.5f, 8.7f, 5.7f};
    air.skyColor = {0.24f, 0.42f, 0.80f};
    air.horizonColor = {0.74f, 0.64f, 0.52f};
    air.groundColor = {0.20f, 0.17f, 0.13f};
    air.fogColor = {0.46f, 0.50f, 0.56f};
    air.exposure = 1.1f;
    air.fogDistance = 150.0f;
    return air;
}

/// A very low sun: fire and lights are the brightest things in view.
inline Environment dusk() {
    Environment air = lateAfternoon();
    air.sunDirection = {-0.90f, 0.14f, 0.42f};
    air.sunColor = {2.6f, 1.25f, 0.62f};
    air.skyColor = {0.075f, 0.13f, 0.27f};
    air.horizonColor = {0.42f, 0.27f, 0.20f};
    air.groundColor = {0.05f, 0.045f, 0.04f};
    air.fogColor = {0.16f, 0.16f, 0.19f};
    air.exposure = 1.7f;
    return air;
}

/// A high sun, short shadows.
inline Environment noon() {
    Environment air;
    air.clouds = 0.42f;
    applySkyModel(air, {-0.38f, 0.86f, 0.34f});
    air.exposure = 0.75f;
    air.fogDistance = 260.0f;
    return air;
}

/// The last of the sun behind the houses: a warm horizon under a blue sky, lights are on, with fog around them.
inline Environment sunset() {
    Environment air;
    air.clouds = 0.46f;
    applySkyModel(air, {-0.70f, 0.062f, -0.66f});
    air.exposure = 1.7f;
    air.fogDistance = 130.0f;
    air.fogDensity = 0.006f;
    air.fogHeight = 9.0f;
    return air;
}

/// Moon and stars; most light comes from street lights and windows.
inline Environment night() {
    Environment air;
    air.clouds = 0.40f;
    applySkyModel(air, {-0.8f, -0.5f, 0.2f});
    air.exposure = 2.6f;
    air.fogDistance = 200.0f;
    air.fogDensity = 0.007f;
    air.fogHeight = 8.0f;
    return air;
}

/// Overcast sky, wet ground, no shadows of the sun.
inline Environment rain() {
    Environment air;
    air.clouds = 1.0f;
    applySkyModel(air, {-0.6f, 0.45f, 0.3f});
    air.wetness = 1.0f;
    air.exposure = 1.1f;
    air.fogDistance = 95.0f;
    air.fogDensity = 0.0018f;
    air.fogHeight = 25.0f;
    air.fogForward = 0.2f;
    return air;
}

/// The environment of a name that `sandbox --time` takes; lateAfternoon() for any other name.
inline Environment timeOfDay(std::string_view name) {
    return name == "noon"    ? noon()
           : name == "dusk"  ? sunset()
           : name == "night" ? night()
           : name == "rain"  ? rain()
                             : lateAfternoon();
}

}  // namespace rubble::scenes
