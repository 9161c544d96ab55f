#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/waiting.h"
#include "runtime/world/settings/settings_error.h"

namespace rubble::abi {
namespace {

/// Calls f(engine's, host's) for each pair of numbers that mean the same: the one list of them for both directions.
template <class Settings, class Host, class F>
void forEachSetting(Settings& s, Host& h, F&& f) {
    f(s.minPieceVoxels, h.min_piece_voxels);
    f(s.impactThreshold, h.impact_threshold);
    f(s.impactSpeed, h.impact_speed);
    f(s.impactRadius, h.impact_radius);
    f(s.impactRadiusLimit, h.impact_radius_limit);
    f(s.split.partsPerStep, h.split_parts);
    f(s.debris.voxels, h.debris_voxels);
    f(s.debris.largestPiece, h.largest_debris);
    f(s.debris.bodies, h.debris_bodies);
    f(s.debris.awakeBodies, h.awake_debris_bodies);
    f(s.debris.settleSteps, h.settle_steps);
    f(s.debris.fragmentsPerBreak, h.fragments_per_break);
    f(s.impactsPerStep, h.impacts_per_step);
    f(s.stress.cracksPerStep, h.cracks_per_step);
    f(s.stress.strengthScale, h.strength_scale);
    f(s.stress.workPerStep, h.stress_work);
    f(s.stress.contactTime, h.contact_time);
    f(s.stress.minImpulse, h.min_load_impulse);
    f(s.stress.minStruckVoxels, h.min_struck_voxels);
    f(s.stress.largestShape, h.largest_stressed);
    f(s.fire.maxFires, h.max_fires);
    f(s.fire.maxHot, h.max_hot);
    f(s.fire.maxLights, h.max_fire_lights);
    f(s.fire.spread, h.fire_spread);
    f(s.fire.burnTime, h.fire_burn_time);
}

WorldSettings readSettings(WorldSettings settings, const rubble_settings& given) {
    const uint32_t flags = readFlags(
        given.flags,
        RUBBLE_SETTING_STRESS | RUBBLE_SETTING_FIRE | RUBBLE_SETTING_PAINT_LAYER | RUBBLE_SETTING_KEEP_ORIGINS,
        "flags");
    // What the engine's narrower numbers cannot hold is refused before they take it.
    readInRange(given.fire_spread, ranges::kFireSpread, "fire_spread");
    readInRange(given.fire_burn_time, ranges::kFireBurnTime, "fire_burn_time");
    readInRange(double(given.stress_work), ranges::kStressWork, "stress_work");
    if (isRefused()) return settings;
    forEachSetting(settings, given, [](auto& to, const auto& from) { to = std::decay_t<decltype(to)>(from); });
    settings.stress.on = flags & RUBBLE_SETTING_STRESS;
    settings.fire.enabled = flags & RUBBLE_SETTING_FIRE;
    settings.paint.mode = flags & RUBBLE_SETTING_PAINT_LAYER ? PaintMode::Layer : PaintMode::Blend;
    settings.physics = PhysicsPreset(readEnum(given.physics_preset, RUBBLE_PHYSICS_ACCURATE, "physics_preset"));
    settings.keepOrigins = flags & RUBBLE_SETTING_KEEP_ORIGINS;
    requireNoError(settingsError(settings));
    return settings;
}

rubble_result setSettings(rubble_world world, const rubble_settings* settings) {
    return inWorld("set_settings", world, [&](HostedWorld& hosted) {
        const rubble_settings given = readStruct(settings, "settings");
        if (!isRefused()) push(hosted, SettingsEdit{readSettings(waitingSettings(hosted), given)});
    });
}

rubble_result getSettings(rubble_world world, rubble_settings* out) {
    return inWorld("get_settings", world, [&](const HostedWorld& hosted) {
        const WorldSettings& settings = hosted.loop.world().settings();
        rubble_settings all = {};
        forEachSetting(settings, all, [](const auto& from, auto& to) { to = std::decay_t<decltype(to)>(from); });
        all.flags = (settings.stress.on ? RUBBLE_SETTING_STRESS : 0) |
                    (settings.fire.enabled ? RUBBLE_SETTING_FIRE : 0) |
                    (settings.paint.mode == PaintMode::Layer ? RUBBLE_SETTING_PAINT_LAYER : 0) |
                    (settings.keepOrigins ? RUBBLE_SETTING_KEEP_ORIGINS : 0);
        all.physics_preset = uint32_t(settings.physics);
        writeStruct(out, all);
    });
}

}  // namespace

void setSettingsFunctions(rubble_api& api) {
    api.set_settings = setSettings;
    api.get_settings = getSettings;
}

}  // namespace rubble::abi
