#include "render/passes/composite_pass.h"

#include "render/passes/depth_limit.h"
#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/passes/glass_shadow_pass.h"
#include "render/passes/local_lights_pass.h"
#include "render/passes/reflections_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

void bindReflections(const Program& program, const FrameContext& frame) {
    program.set("uHasReflections", int(ReflectionsPass::needed(frame)));
    program.set("uReflection", frame.targets.orNone(Target::Reflection));
    program.set("uHasGlass", int(frame.scene.hasGlass()));
    program.set("uGlassSurface", frame.targets.orNone(Target::GlassSurface));
}

}  // namespace

CompositePass::CompositePass(ShaderLibrary& shaders)
    : m_surfaces(shaders.loadFullscreen("passes/composite.frag", {.surfacesOnly = true})) {
    m_backgrounds[BackgroundTiles::Sky] = &shaders.load("passes/background_sky.frag", "passes/tiles.vert");
    m_backgrounds[BackgroundTiles::Fields] = &shaders.load("passes/background_fields.frag", "passes/tiles.vert");
    m_backgrounds[BackgroundTiles::Both] = &shaders.load("passes/background.frag", "passes/tiles.vert");
}

void CompositePass::draw(const FrameContext& frame, const GlassShadowPass* glassShadow) {
    if (!m_surfaces) return;
    const Texture& radiance = frame.targets.history(Target::Radiance).current;
    const FullscreenTargets into{{&radiance, &frame.targets.history(Target::DiffuseFraction).current},
                                 &frame.targets.at(Target::DepthBuffer)};
    drawFullscreen(frame, m_surfaces, into, [&](const Program& program) {
        GBufferPass::bind(program, frame.targets);
        bindReflections(program, frame);
        program.set("uLight", frame.targets.at(Target::DenoisedLight));
        program.set("uHasLocalLights", int(LocalLightsPass::needed(frame)));
        program.set("uSpecular", frame.targets.orNone(Target::Specular));
        program.set("uSurface", frame.targets.history(Target::Surface).current);
        program.set("uBevel", int(frame.settings.bevel));
        program.set("uDetail", int(GBufferPass::hasDetail(frame)));
        GlassShadowPass::bind(program, glassShadow);
    });
    frame.targets.framebuffer({&radiance}, into.depth).begin();
    drawBackground(frame);
}

void CompositePass::drawBackground(const FrameContext& frame) {
    const DepthLimit limit(DepthLimit::To::Sky);
    m_tiles.update(frame.block);
    for (const auto band : {BackgroundTiles::Sky, BackgroundTiles::Fields, BackgroundTiles::Both}) {
        const Program& program = *m_backgrounds[band];
        if (!program || m_tiles.empty(band)) continue;
        program.use();
        m_tiles.draw(program, band, frame);
    }
}

}  // namespace rubble
