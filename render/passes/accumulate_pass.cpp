#include "render/passes/accumulate_pass.h"

#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr double kBrickMetres = 1.6;  // of the shadow volume
constexpr int kTile = 4;              // pixels: passes/light_change.frag

/// Where what casts shadows has changed, for passes/light_change.frag.
void setDirtyRegions(const Program& program, const Scene& scene) {
    std::vector<glm::vec4> corners;
    for (const DirtyRegions::Box& box : scene.dirtyRegions().boxes())
        for (const glm::ivec3& corner : {box.low, box.high})
            corners.emplace_back(glm::vec3(glm::dvec3(corner) * kBrickMetres - scene.origin()), 0.0f);
    program.set("uDirtyCornerCount", int(corners.size()));
    if (!corners.empty()) program.set("uDirtyCorners[0]", std::span<const glm::vec4>(corners));
}

}  // namespace

AccumulatePass::AccumulatePass(ShaderLibrary& shaders)
    : m_change(shaders.loadFullscreen("passes/light_change.frag")),
      m_program(shaders.loadFullscreen("passes/accumulate.frag", {.limited = true})) {}

const Texture& AccumulatePass::findChanges(const FrameContext& frame, const History& light,
                                           const History& surface) const {
    const History pulse = frame.targets.history("fastHistory", GL_RGBA16F, kTile);
    const Texture& trusted = frame.targets.target("historyConfidence", GL_RG8, kTile, Filter::Linear);
    drawFullscreen(frame, m_change, {frame.targets, {&pulse.current, &trusted}}, [&](const Program& program) {
        program.set("uLight", frame.targets.at("noisyLight"));
        program.set("uMotion", frame.targets.at("motion"));
        program.set("uLightHistory", light.previous);
        program.set("uSurfaceHistory", surface.previous);
        program.set("uFastHistory", pulse.previous);
        program.set("uHistoryValid", int(light.valid && surface.valid && pulse.valid));
        program.set("uDepth", frame.targets.at("depth"));
        setDirtyRegions(program, frame.scene);
    });
    return trusted;
}

void AccumulatePass::draw(const FrameContext& frame) const {
    if (!m_change || !m_program) return;
    const History light = frame.targets.history("accumulatedLight", GL_RGBA16F);
    const History surface = frame.targets.history("surface", GL_RGBA32F);
    const bool remembers = frame.settings.temporal && light.valid && surface.valid;
    const bool forgets = remembers && frame.settings.rejectStaleHistory;
    const Texture& trusted = forgets ? findChanges(frame, light, surface) : frame.blueNoise;  // else not looked at
    const glm::vec4 none(0.0f), sky(GBufferPass::kSkyDepth, -1, 0, 0);
    const FullscreenTargets into{
        frame.targets, {&light.current, &surface.current}, &frame.targets.at("depthBuffer"), {none, sky}};
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        GBufferPass::bind(program, frame.targets);
        program.set("uLight", frame.targets.at("noisyLight"));
        program.set("uHasHitProximity", int(frame.settings.sky));
        if (frame.settings.sky) program.set("uHitProximity", frame.targets.at("hitProximity"));
        program.set("uLightHistory", light.previous);
        program.set("uSurfaceHistory", surface.previous);
        program.set("uHistoryConfidence", trusted);
        program.set("uHasConfidence", int(forgets));
        program.set("uHistoryValid", int(remembers));
        program.set("uMaxHistory", float(frame.settings.historyFrames));
    });
}

}  // namespace rubble
