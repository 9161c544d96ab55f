#pragma once
#include <cstdint>

namespace rubble {

/// How heat spreads, and budgets for it. What the budgets refuse is counted in FrameChanges.
struct FireSettings {
    bool enabled = true;      ///< false: HeatEdit does nothing; fires go out in the next step
    uint32_t maxFires = 512;  ///< burning bricks; more only get hot
    uint32_t maxHot = 8192;   ///< bricks that are hot, burning or wet; heat of others is lost
    uint32_t maxLights = 8;   ///< point lights for the biggest fires
    float spread = 1.0f;      ///< multiple of the heat that fires pass on
    float burnTime = 1.0f;    ///< multiple of Material::burnTime

    friend bool operator==(const FireSettings&, const FireSettings&) = default;
};

}  // namespace rubble
