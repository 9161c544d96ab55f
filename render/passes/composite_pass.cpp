#include "render/passes/composite_pass.h"

#include "render/passes/depth_limit.h"
#include "render/passes/gbuffer_pass.h"
#include "render/passes/glass_shadow_pass.h"
#include "render/passes/local_lights_pass.h"
#include "render/passes/reflections_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr double kPlaneHeight = -0.05;  // of the fields around a level, whose ground ends at 0

/// Sets the uniforms of lib/glass.glsl.
void bindGlass(const Program& program, const FrameContext& frame) {
    const bool reflections = ReflectionsPass::needed(frame);
    program.set("uReflections", int(reflections));
    if (reflections) program.set("uReflection", frame.targets.at("reflection"));
    const Texture* pane = frame.targets.find("glassSurface");
    const bool glass = pane && frame.scene.hasGlass();
    program.set("uGlass", int(glass));
    if (!glass) return;
    program.set("uGlassSurface", *pane);
    program.set("uGlassTint", frame.targets.at("glassTint"));
}

}  // namespace

CompositePass::CompositePass(ShaderLibrary& shaders)
    : m_surfaces(shaders.load("passes/composite.frag", kFarVertexShader)), m_background(shaders.load("passes/background.frag", kFarVertexShader)) {}

void CompositePass::draw(const FrameContext& frame, const GlassShadowPass* glassShadow) const {
    if (!m_surfaces || !m_background) return;
    frame.targets.framebuffer({&frame.targets.history("radiance", GL_RGBA16F).current}, &frame.targets.at("depthBuffer")).begin();
    {
        const DepthLimit limit(DepthLimit::To::Surfaces);
        m_surfaces.use();
        GBufferPass::bind(m_surfaces, frame.targets);
        bindGlass(m_surfaces, frame);
        m_surfaces.set("uLight", frame.targets.at("lighting"));
        m_surfaces.set("uLocalLights", int(LocalLightsPass::needed(frame)));
        if (LocalLightsPass::needed(frame)) m_surfaces.set("uSpecular", frame.targets.at("specular"));
        m_surfaces.set("uBevel", int(frame.settings.bevel));
        m_surfaces.set("uGlassShadow", 0);
        if (glassShadow) glassShadow->bind(m_surfaces);
        frame.drawFullscreen();
    }
    const DepthLimit limit(DepthLimit::To::Sky);
    m_background.use();
    bindGlass(m_background, frame);
    m_background.set("uPlaneHeight", float(kPlaneHeight - frame.scene.origin().y));
    frame.drawFullscreen();
}

}  // namespace rubble
