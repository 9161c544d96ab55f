#pragma once
#include <array>
#include <tuple>

#include "runtime/core/fields.h"
#include "runtime/world/settings/world_settings.h"

// The one table of a world's settings (see fields.h): what is in it is saved, recorded, carried by deltas and hashed.
namespace rubble {

template <>
inline constexpr std::array<const char*, 3> kEnumNames<BoundsRule> = {"dust", "keep", "ground"};
template <>
inline constexpr std::array<const char*, 4> kEnumNames<PhysicsPreset> = {"given", "fast", "balanced", "accurate"};
template <>
inline constexpr std::array<const char*, 3> kEnumNames<PaintMode> = {"default", "blend", "layer"};

template <>
inline constexpr auto kFields<BoundsSettings> = std::tuple{
    Field{"rule", &BoundsSettings::rule},
    Field{"low", &BoundsSettings::low},
    Field{"high", &BoundsSettings::high},
};
template <>
inline constexpr auto kFields<DebrisSettings> = std::tuple{
    Field{"awake_bodies", &DebrisSettings::awakeBodies},
    Field{"bodies", &DebrisSettings::bodies},
    Field{"voxels", &DebrisSettings::voxels},
    Field{"largest_piece", &DebrisSettings::largestPiece},
    Field{"settle_steps", &DebrisSettings::settleSteps},
    Field{"fragments_per_break", &DebrisSettings::fragmentsPerBreak},
};
template <>
inline constexpr auto kFields<StressSettings> = std::tuple{
    Field{"on", &StressSettings::on},
    Field{"strength_scale", &StressSettings::strengthScale},
    Field{"work_per_step", &StressSettings::workPerStep},
    Field{"cracks_per_step", &StressSettings::cracksPerStep},
    Field{"contact_time", &StressSettings::contactTime},
    Field{"min_impulse", &StressSettings::minImpulse},
    Field{"min_struck_voxels", &StressSettings::minStruckVoxels},
    Field{"largest_shape", &StressSettings::largestShape},
};
template <>
inline constexpr auto kFields<SplitSettings> = std::tuple{
    Field{"parts_per_step", &SplitSettings::partsPerStep},
};
template <>
inline constexpr auto kFields<PaintSettings> = std::tuple{
    Field{"mode", &PaintSettings::mode},
};
template <>
inline constexpr auto kFields<FireSettings> = std::tuple{
    Field{"enabled", &FireSettings::enabled}, Field{"max_fires", &FireSettings::maxFires},
    Field{"max_hot", &FireSettings::maxHot},  Field{"max_lights", &FireSettings::maxLights},
    Field{"spread", &FireSettings::spread},   Field{"burn_time", &FireSettings::burnTime},
};
template <>
inline constexpr auto kFields<WorldSettings> = std::tuple{
    Field{"min_piece_voxels", &WorldSettings::minPieceVoxels},
    Field{"impact_threshold", &WorldSettings::impactThreshold},
    Field{"impact_speed", &WorldSettings::impactSpeed},
    Field{"impact_radius", &WorldSettings::impactRadius},
    Field{"impact_radius_limit", &WorldSettings::impactRadiusLimit},
    Field{"impacts_per_step", &WorldSettings::impactsPerStep},
    Field{"undo_marks", &WorldSettings::undoMarks},
    Field{"bounds", &WorldSettings::bounds},
    Field{"debris", &WorldSettings::debris},
    Field{"stress", &WorldSettings::stress},
    Field{"paint", &WorldSettings::paint},
    Field{"fire", &WorldSettings::fire},
    Field{"split", &WorldSettings::split},
    Field{"keep_origins", &WorldSettings::keepOrigins},
    Field{"physics", &WorldSettings::physics},
};

}  // namespace rubble
