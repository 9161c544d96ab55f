#include "render/passes/gbuffer_pass.h"

#include "render/scene/scene.h"

namespace rubble {

GBufferPass::GBufferPass(ShaderLibrary& shaders)
    : m_program(shaders.load("passes/gbuffer.frag", "passes/tiles.vert")) {}

void GBufferPass::draw(const FrameContext& frame) {
    TargetPool& targets = frame.targets;
    const Texture& albedo = targets.target(Target::Albedo);
    const Texture& normal = targets.target(Target::Normal);
    const Texture& material = targets.target(Target::Material);
    const Texture& motion = targets.target(Target::Motion);
    const Texture& depth = targets.target(Target::Depth);
    const Texture& depthBuffer = targets.target(Target::DepthBuffer);
    const bool hasGlass = frame.scene.hasGlass();
    const Framebuffer& gbuffer =
        hasGlass ? targets.framebuffer(
                       {&albedo, &normal, &material, &motion, &depth, &targets.target(Target::GlassMask)}, &depthBuffer)
                 : targets.framebuffer({&albedo, &normal, &material, &motion, &depth}, &depthBuffer);
    const float zero[4] = {0, 0, 0, 0}, sky[4] = {kSkyDepth, 0, 0, 0};
    gbuffer.begin();
    for (int i = 0; i < 4; ++i) glClearBufferfv(GL_COLOR, i, zero);
    glClearBufferfv(GL_COLOR, 4, sky);
    if (hasGlass) glClearBufferfv(GL_COLOR, 5, zero);
    const float farthest = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &farthest);

    m_tiles.update(frame.scene.bodies(), frame.block);
    if (!m_program || m_tiles.empty(BodyTiles::Which::All)) return;
    m_program.use();
    frame.scene.bodies().bind(m_program);
    m_tiles.bind(m_program, BodyTiles::Which::All);
    m_program.set("uDetail", int(hasDetail(frame)));
    if (hasDetail(frame) && !m_details) m_details.emplace();
    m_program.set("uDetailMaps", m_details ? m_details->texture() : m_noDetails);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    m_tiles.drawTiles(m_program, BodyTiles::Which::All, frame.emptyVertexArray);
    ++frame.stats.drawCalls;
    ++frame.stats.bodyDraws;
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

bool GBufferPass::hasDetail(const FrameContext& frame) {
    return frame.settings.detail && frame.scene.bodies().hasDetail();
}

void GBufferPass::bind(const Program& program, const TargetPool& targets) {
    program.set("uAlbedo", targets.at(Target::Albedo));
    program.set("uNormal", targets.at(Target::Normal));
    program.set("uMaterial", targets.at(Target::Material));
    program.set("uMotion", targets.at(Target::Motion));
    program.set("uDepth", targets.at(Target::Depth));
}

}  // namespace rubble
