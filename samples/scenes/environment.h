#pragma once
#include "runtime/world/lights.h"

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

/// The sun is nearly down: what burns or glows is the brightest thing there is.
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

}  // namespace rubble::scenes
