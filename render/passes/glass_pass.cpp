#include "render/passes/glass_pass.h"

#include "render/scene/scene.h"

namespace rubble {

GlassPass::GlassPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/glass.frag", "passes/tiles.vert")) {}

void GlassPass::draw(const FrameContext& frame, const BodyTiles& tiles) const {
    const Texture& tint = frame.targets.target("glassTint", GL_RGBA8);
    const Texture& surface = frame.targets.target("glassSurface", GL_RGBA16F);
    frame.targets.framebuffer({&tint, &surface}).begin();
    const float clear[4] = {1, 1, 1, 1}, none[4] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, clear);
    glClearBufferfv(GL_COLOR, 1, none);
    if (!m_program || tiles.empty(BodyTiles::Which::Glass)) return;
    m_program.use();
    frame.scene.bodies().bind(m_program);
    tiles.bind(m_program, BodyTiles::Which::Glass);
    m_program.set("uDepth", frame.targets.at("depth"));
    tiles.drawTiles(m_program, BodyTiles::Which::Glass, frame.emptyVertexArray);
    ++frame.figures.drawCalls;
    ++frame.figures.bodyDraws;
}

}  // namespace rubble
