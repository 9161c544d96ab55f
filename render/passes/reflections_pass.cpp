#include "render/passes/reflections_pass.h"

#include "render/passes/bounce.h"
#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

/// Sets the samplers of lib/mirror.glsl and of the G-buffer.
void bindMirror(const Program& program, const FrameContext& frame) {
    GBufferPass::bind(program, frame.targets);
    const Texture* pane = frame.targets.find(Target::GlassSurface);
    const bool glass = pane && frame.scene.hasGlass();
    program.set("uHasGlass", int(glass));
    if (glass) program.set("uGlassSurface", *pane);
}

}  // namespace

ReflectionsPass::ReflectionsPass(ShaderLibrary& shaders)
    : m_mask(shaders.load("passes/reflection_mask.frag")),
      m_program(shaders.loadFullscreen("passes/reflections.frag", {.surfacesOnly = true})) {}

bool ReflectionsPass::needed(const FrameContext& frame) {
    return frame.settings.reflections &&
           (frame.scene.hasMirrors() || frame.scene.hasGlass() || frame.scene.environment().wetness > 0.0f);
}

void ReflectionsPass::draw(const FrameContext& frame) const {
    if (!m_mask || !m_program) return;
    const Texture& mask = frame.targets.target(Target::ReflectionMask);
    frame.targets.framebuffer({}, &mask).begin();
    const float farthest = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);  // the triangle lies at depth one half, before the far plane
    m_mask.use();
    bindMirror(m_mask, frame);
    frame.drawTriangle();
    glDisable(GL_DEPTH_TEST);

    const FullscreenTargets into{{&frame.targets.target(Target::Reflection)}, &mask, {glm::vec4(0.0f)}};
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        bindMirror(program, frame);
        frame.scene.bindShadow(program);
        bindBounce(program, frame, BounceRays::Mirrored);
        program.set("uLight", frame.targets.at(Target::DenoisedLight));
        program.set("uBlueNoise", frame.blueNoise);
    });
}

}  // namespace rubble
