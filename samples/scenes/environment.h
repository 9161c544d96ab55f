#pragma once
#include "runtime/world/lights.h"

namespace rubble::scenes {

/// A low sun from the left, a clear cool sky, a little haze.
inline Environment lateAfternoon() {
    Environment air;
    air.sunDirection = {-0.90f, 0.36f, 0.08f};
    air.sunColor = {9.0f, 7.6f, 5.8f};
    air.skyColor = {0.55f, 0.70f, 1.00f};
    air.horizonColor = {0.95f, 0.86f, 0.76f};
    air.groundColor = {0.22f, 0.20f, 0.18f};
    air.fogColor = {0.62f, 0.66f, 0.72f};
    air.fogDistance = 150.0f;
    return air;
}

}  // namespace rubble::scenes
