#include "render/passes/glass_pass.h"

#include "render/passes/reflections_pass.h"
#include "render/scene/scene.h"

namespace rubble {

GlassPass::GlassPass(ShaderLibrary& shaders)
    : m_mask(shaders.load("passes/glass_mask.frag", "passes/tiles.vert")),
      m_program(shaders.load("passes/glass.frag", "passes/tiles.vert")),
      m_over(shaders.load("passes/glass_composite.frag", "passes/tiles.vert")) {}

void GlassPass::draw(const FrameContext& frame, const BodyTiles& tiles) const {
    const Texture& tint = frame.targets.target("glassTint", GL_RGBA8);
    const Texture& surface = frame.targets.target("glassSurface", GL_RGBA16F);
    frame.targets.framebuffer({&tint, &surface}, &frame.targets.target("glassDepth", GL_DEPTH_COMPONENT32F)).begin();
    const float clear[4] = {1, 1, 1, 1}, none[4] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, clear);
    glClearBufferfv(GL_COLOR, 1, none);
    glClearBufferfv(GL_DEPTH, 0, none);
    if (!m_program || !m_mask || tiles.empty(BodyTiles::Which::Glass)) return;
    glEnable(GL_DEPTH_TEST);
    drawMask(frame, tiles);
    // What is not marked is rejected before its shader runs, where a branch in the shader would be walked through.
    glDepthFunc(GL_EQUAL);
    m_program.use();
    frame.scene.bodies().bind(m_program);
    tiles.bind(m_program, BodyTiles::Which::Glass);
    m_program.set("uDepth", frame.targets.at("depth"));
    tiles.drawTiles(m_program, BodyTiles::Which::Glass, frame.emptyVertexArray);
    frame.figures.drawCalls += 2;
    frame.figures.bodyDraws += 2;
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

void GlassPass::drawMask(const FrameContext& frame, const BodyTiles& tiles) const {
    m_mask.use();
    tiles.bind(m_mask, BodyTiles::Which::Glass);
    m_mask.set("uGlassMask", frame.targets.at("glassMask"));
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_ALWAYS);
    tiles.drawTiles(m_mask, BodyTiles::Which::Glass, frame.emptyVertexArray);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void GlassPass::drawOver(const FrameContext& frame, const BodyTiles& tiles) const {
    if (!m_over || tiles.empty(BodyTiles::Which::Glass)) return;
    const Texture& picture = frame.targets.at("radiance");
    const Texture& behind = frame.targets.copy(picture, "behindGlass");
    frame.targets.framebuffer({&picture}, &frame.targets.at("glassDepth")).begin();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_EQUAL);
    m_over.use();
    tiles.bind(m_over, BodyTiles::Which::Glass);
    const bool reflections = ReflectionsPass::needed(frame);
    m_over.set("uHasReflections", int(reflections));
    if (reflections) m_over.set("uReflection", frame.targets.at("reflection"));
    m_over.set("uRefraction", int(frame.settings.refraction));
    m_over.set("uBackground", behind);
    m_over.set("uDepth", frame.targets.at("depth"));
    m_over.set("uGlassTint", frame.targets.at("glassTint"));
    m_over.set("uGlassSurface", frame.targets.at("glassSurface"));
    tiles.drawTiles(m_over, BodyTiles::Which::Glass, frame.emptyVertexArray);
    ++frame.figures.drawCalls;
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace rubble
