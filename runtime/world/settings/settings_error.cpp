#include "runtime/world/settings/settings_error.h"

#include <glm/vector_relational.hpp>

#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"

namespace rubble {

std::string boundsError(const BoundsSettings& s) {
    return RangeCheck()
        .number("rule", double(s.rule), {0.0, double(BoundsRule::Ground)})
        .vector("low", s.low, ranges::kCoordinate)
        .vector("high", s.high, ranges::kCoordinate)
        .require(s.low == s.high || glm::all(glm::lessThan(s.low, s.high)),
                 "low and high: expected low below high along each axis, or both equal")
        .error();
}

std::string settingsError(const WorldSettings& s) {
    return RangeCheck()
        .number("impact_threshold", s.impactThreshold, ranges::kImpactThreshold)
        .number("impact_speed", s.impactSpeed, ranges::kImpactSpeed)
        .number("impact_radius", s.impactRadius, ranges::kImpactRadius)
        .number("impact_radius_limit", s.impactRadiusLimit, ranges::kImpactRadius)
        .number("impacts_per_step", double(s.impactsPerStep), ranges::kImpactsPerStep)
        .number("fragments_per_break", double(s.debris.fragmentsPerBreak), ranges::kFragments)
        .number("physics_preset", double(s.physics), {0.0, double(PhysicsPreset::Accurate)})
        .number("mode", double(s.paint.mode), {0.0, double(PaintMode::Layer)})
        .number("strength_scale", s.stress.strengthScale, ranges::kStrengthScale)
        .number("stress_work", double(s.stress.workPerStep), ranges::kStressWork)
        .number("contact_time", s.stress.contactTime, ranges::kContactTime)
        .number("min_load_impulse", s.stress.minImpulse, ranges::kImpactThreshold)
        .number("fire_spread", double(s.fire.spread), ranges::kFireSpread)
        .number("fire_burn_time", double(s.fire.burnTime), ranges::kFireBurnTime)
        .include(boundsError(s.bounds))
        .error();
}

}  // namespace rubble
