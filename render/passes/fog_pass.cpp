#include "render/passes/fog_pass.h"

#include <algorithm>

#include "render/passes/fullscreen.h"
#include "render/passes/local_lights_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"
#include "render/scene/water_area.h"

namespace rubble {
namespace {

constexpr const char* kNoFog = "fog is not drawn";
/// Frames averaged while nothing changes, and while anything does: light through a new hole takes no longer to appear.
constexpr int kMaxHistory = 128, kMaxHistoryAfterChange = 12;

}  // namespace

FogPass::FogPass(ShaderLibrary& shaders)
    : m_light(shaders.loadFullscreen("passes/fog_light.frag", {}, kNoFog)),
      m_filter(shaders.loadFullscreen("passes/fog_filter.frag", {}, kNoFog)),
      m_over(shaders.loadFullscreen("passes/fog.frag", {.merge = {Merge::Over}}, kNoFog)) {}

bool FogPass::needed(const FrameContext& frame) {
    return frame.block.fog.x > 0.0f;
}

int FogPass::maxHistory(const FrameContext& frame) {
    const bool changed = !frame.scene.dirtyRegions().boxes().empty() || m_environment != frame.scene.environment();
    m_environment = frame.scene.environment();
    const int frames = changed ? kMaxHistoryAfterChange : kMaxHistory;
    return frame.lightGrid ? std::min(frames, frame.lightGrid->framesSinceChange() + 1) : frames;
}

void FogPass::drawLight(const FrameContext& frame) {
    const History light = frame.targets.history(Target::FogLight);
    const bool lights = LocalLightsPass::needed(frame) && !frame.lightGrid->empty();
    const int frames = maxHistory(frame);
    drawFullscreen(frame, m_light, {{&light.current}}, [&](const Program& program) {
        frame.scene.bindShadow(program);
        LightGrid::bind(program, frame.lightGrid);
        program.set("uHasLocalLights", int(lights));
        program.set("uDepth", frame.targets.at(Target::Depth));
        program.set("uBlueNoise", frame.blueNoise);
        program.set("uHistory", light.previous);
        program.set("uHistoryValid", int(frame.settings.temporal && light.valid));
        program.set("uSunUp", int(frame.settings.sun && frame.block.sunDirection.y > 0.0f));
        program.set("uMaxHistory", float(frames));
    });
}

void FogPass::drawFilter(const FrameContext& frame) const {
    const Texture& fog = frame.targets.target(Target::Fog);
    drawFullscreen(frame, m_filter, {{&fog}}, [&](const Program& program) {
        program.set("uLight", frame.targets.at(Target::FogLight));
        program.set("uDepth", frame.targets.at(Target::Depth));
    });
}

void FogPass::drawOver(const FrameContext& frame, const Texture& fog) const {
    if (!m_over) return;
    drawFullscreen(frame, m_over, {{&frame.targets.at(Target::Radiance)}}, [&](const Program& program) {
        program.set("uLight", fog);
        const glm::dvec3 camera = glm::dvec3(frame.block.cameraPosition) + frame.scene.origin();
        const double surface = waterSurfaceOver(frame.scene.waters(), camera).value_or(-1e9);
        program.set("uWaterSurface", float(surface - frame.scene.origin().y));
        program.set("uDepth", frame.targets.at(Target::Depth));
    });
}

void FogPass::draw(const FrameContext& frame) {
    if (!m_light || !m_filter || !m_over) return;
    drawLight(frame);
    drawFilter(frame);
    drawOver(frame, frame.targets.at(Target::Fog));
}

}  // namespace rubble
