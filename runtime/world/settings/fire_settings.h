#pragma once
#include <cstdint>

namespace rubble {

/// How heat spreads and what it costs at most. Budgets count work; what they refuse is counted in FrameChanges.
struct FireSettings {
    bool enabled = true;      ///< false: HeatEdit does nothing; fires go out in the next step
    uint32_t maxFires = 512;  ///< burning bricks; more only get hot
    uint32_t maxHot = 8192;   ///< bricks that are hot, burning or wet; the heat of more is lost
    uint32_t maxLights = 8;   ///< point lights for the biggest fires
    float spread = 1.0f;      ///< how much of a fire's heat reaches what is near, as a multiple
    float burnTime = 1.0f;    ///< multiple of Material::burnTime
};

}  // namespace rubble
