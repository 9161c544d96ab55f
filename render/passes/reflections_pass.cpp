#include "render/passes/reflections_pass.h"

#include <algorithm>

#include "render/passes/bounce.h"
#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/passes/known_changes.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

/// Sets the samplers of lib/mirror.glsl and of the G-buffer.
void bindMirror(const Program& program, const FrameContext& frame) {
    GBufferPass::bind(program, frame.targets);
    const Texture& pane = frame.targets.orNone(Target::GlassSurface);
    program.set("uHasGlass", int(pane && frame.scene.hasGlass()));
    program.set("uGlassSurface", pane);
}

constexpr int kMaxFilterPasses = 3;  ///< lobes of traced reflections reach no farther
const glm::vec4 kNone(0.0f);

}  // namespace

ReflectionsPass::ReflectionsPass(ShaderLibrary& shaders)
    : m_mask(shaders.load("passes/reflection_mask.frag")),
      m_program(shaders.loadFullscreen("passes/reflections.frag", {.surfacesOnly = true})),
      m_accumulate(shaders.loadFullscreen("passes/reflection_accumulate.frag", {.surfacesOnly = true})),
      m_accumulateChanged(shaders.loadFullscreen("passes/reflection_accumulate_changed.frag", {.surfacesOnly = true})),
      m_filter(shaders.loadFullscreen("passes/reflection_filter.frag", {.surfacesOnly = true})) {}

bool ReflectionsPass::needed(const FrameContext& frame) {
    return frame.settings.reflections &&
           (frame.scene.hasMirrors() || frame.scene.hasGlass() || frame.scene.environment().wetness > 0.0f);
}

void ReflectionsPass::draw(const FrameContext& frame) const {
    if (!m_mask || !m_program || !m_accumulate || !m_accumulateChanged || !m_filter) return;
    const Texture& mask = drawMask(frame);
    const FullscreenTargets into{{&frame.targets.target(Target::NoisyReflection)}, &mask, {kNone}};
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        bindMirror(program, frame);
        frame.scene.bindShadow(program);
        bindBounce(program, frame, BounceRays::Mirrored);
        program.set("uLight", frame.targets.at(Target::DenoisedLight));
        program.set("uBlueNoise", frame.blueNoise);
    });
    accumulate(frame, mask);
    filter(frame, mask);
}

const Texture& ReflectionsPass::drawMask(const FrameContext& frame) const {
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
    return mask;
}

void ReflectionsPass::accumulate(const FrameContext& frame, const Texture& mask) const {
    const History light = frame.targets.history(Target::AccumulatedReflection);
    const History moments = frame.targets.history(Target::ReflectionMoments);
    const History surface = frame.targets.history(Target::Surface);
    const FullscreenTargets into{{&light.current, &moments.current}, &mask, {kNone, kNone}};
    drawFullscreen(
        frame, hasKnownChanges(frame) ? m_accumulateChanged : m_accumulate, into, [&](const Program& program) {
            bindMirror(program, frame);
            setKnownChanges(program, frame);
            program.set("uNoisyReflection", frame.targets.at(Target::NoisyReflection));
            program.set("uReflectionHistory", light.previous);
            program.set("uMomentHistory", moments.previous);
            program.set("uSurfaceHistory", surface.previous);
            program.set("uHistoryValid", int(frame.settings.temporal && light.valid && moments.valid && surface.valid));
        });
}

void ReflectionsPass::filter(const FrameContext& frame, const Texture& mask) const {
    const Texture* source = &frame.targets.at(Target::AccumulatedReflection);
    const int steps = std::clamp(frame.settings.filterPasses, 1, kMaxFilterPasses);
    for (int step = 0; step < steps; ++step) {
        // The two targets alternate; the last step writes Reflection.
        const bool isFinal = (steps - step) % 2;
        const Texture& target = frame.targets.target(isFinal ? Target::Reflection : Target::NoisyReflection);
        FullscreenTargets into{{&target}, &mask};
        if (isFinal && step < 2) into.clear = {kNone};  // the other target was cleared for the rays
        drawFullscreen(frame, m_filter, into, [&](const Program& program) {
            program.set("uReflection", *source);
            program.set("uMoments", frame.targets.at(Target::ReflectionMoments));
            program.set("uSurface", frame.targets.at(Target::Surface));
            // Without filter passes one step of stride 0 copies each pixel.
            program.set("uStride", frame.settings.filterPasses ? 1 << step : 0);
            program.set("uDiagonal", step % 2);
            program.set("uIsLast", int(step + 1 == steps));
        });
        source = &target;
    }
}

}  // namespace rubble
