#include "render/passes/local_lights_pass.h"

#include <algorithm>

#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/passes/history_left_pass.h"
#include "render/passes/reflections_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr float kFullRayRadiance = 0.01f;  ///< of a white surface at exposure 1; fainter light gets fewer rays
constexpr int kMaxHighlightHistory = LightGrid::kMaxChangeFrames;  ///< frames over which highlights are averaged

/// Where lights have changed, for the histories around them.
void setChanges(const Program& program, const FrameContext& frame) {
    std::vector<glm::vec4> changes;
    for (const LightGrid::Change& change : frame.lightGrid->changes()) {
        changes.emplace_back(glm::vec3(change.after.light.position - frame.scene.origin()), change.range());
        changes.emplace_back(float(change.frames + 1));
    }
    program.set("uLightChangeCount", int(changes.size()));
    if (!changes.empty()) program.set("uLightChange[0]", std::span<const glm::vec4>(changes));
}

}  // namespace

LocalLightsPass::LocalLightsPass(ShaderLibrary& shaders)
    : m_program(shaders.loadFullscreen(
          "passes/local_lights.frag",
          {.surfacesOnly = true, .merge = {Merge::Add}, .vertexFile = "passes/local_lights.vert"},
          "local lights are not drawn")) {}

bool LocalLightsPass::needed(const FrameContext& frame) {
    return frame.settings.localLights && frame.lightGrid && frame.lightGrid->hasLights();
}

void LocalLightsPass::draw(const FrameContext& frame) const {
    const History specular = frame.targets.history(Target::Specular);
    const History surface = frame.targets.history(Target::Surface);
    frame.targets.framebuffer({&specular.current}).begin();
    const float none[4] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, none);
    if (!m_program || frame.lightGrid->empty()) return;
    const FullscreenTargets into{.colors = {&frame.targets.target(Target::NoisyLight), &specular.current},
                                 .depth = &frame.targets.at(Target::DepthBuffer),
                                 .tiles = frame.lightGrid->tiles()};
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        GBufferPass::bind(program, frame.targets);
        frame.scene.bindShadow(program);
        LightGrid::bind(program, frame.lightGrid);
        program.set("uBlueNoise", frame.blueNoise);
        program.set("uSpecularHistory", specular.previous);
        program.set("uSurfaceHistory", surface.previous);
        program.set("uHistoryValid", int(frame.settings.temporal && specular.valid && surface.valid));
        program.set("uMaxHighlightHistory", float(kMaxHighlightHistory));
        setChanges(program, frame);
        HistoryLeftPass::bind(program, frame);
        program.set("uHasReflections", int(ReflectionsPass::needed(frame)));
        program.set("uFullRayRadiance", kFullRayRadiance / frame.block.exposure.x);
    });
}

}  // namespace rubble
