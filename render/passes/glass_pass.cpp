#include "render/passes/glass_pass.h"

#include "render/passes/reflections_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr GLuint kColors = 2;  ///< that the pass fills: tint and surface

}  // namespace

GlassPass::GlassPass(ShaderLibrary& shaders)
    : m_mask(shaders.load("passes/glass_mask.frag", "passes/tiles.vert")),
      m_program(shaders.load("passes/glass.frag", "passes/tiles.vert")),
      m_light(shaders.load("passes/pane_light.frag", "passes/tiles.vert")),
      m_over(shaders.load("passes/glass_composite.frag", "passes/tiles.vert")) {}

void GlassPass::draw(const FrameContext& frame, const BodyTiles& tiles) const {
    const Texture& tint = frame.targets.target(Target::GlassTint);
    const Texture& surface = frame.targets.target(Target::GlassSurface);
    frame.targets.framebuffer({&tint, &surface}, &frame.targets.target(Target::GlassDepth)).begin();
    const float clear[4] = {1, 1, 1, 1}, none[4] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, clear);
    glClearBufferfv(GL_COLOR, 1, none);
    glClearBufferfv(GL_DEPTH, 0, none);
    if (!m_program || !m_mask || tiles.empty(BodyTiles::Which::Glass)) return;
    glEnable(GL_DEPTH_TEST);
    drawMask(frame, tiles);
    // The depth test rejects unmarked pixels before their shader runs; a branch in the shader would not.
    glDepthFunc(GL_EQUAL);
    m_program.use();
    frame.scene.bodies().bind(m_program);
    tiles.bind(m_program, BodyTiles::Which::Glass);
    m_program.set("uDepth", frame.targets.at(Target::Depth));
    tiles.drawTiles(m_program, BodyTiles::Which::Glass, frame.emptyVertexArray);
    frame.stats.drawCalls += 2;
    frame.stats.bodyDraws += 2;
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

/// Marks in the depth buffer the pixels that the G-buffer pass saw through glass.
void GlassPass::drawMask(const FrameContext& frame, const BodyTiles& tiles) const {
    m_mask.use();
    tiles.bind(m_mask, BodyTiles::Which::Glass);
    m_mask.set("uGlassMask", frame.targets.at(Target::GlassMask));
    for (GLuint i = 0; i < kColors; ++i) glColorMaski(i, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_ALWAYS);
    tiles.drawTiles(m_mask, BodyTiles::Which::Glass, frame.emptyVertexArray);
    for (GLuint i = 0; i < kColors; ++i) glColorMaski(i, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/// Draws the pixels with panes by a program that includes lib/pane_light.glsl.
template <class SetUniforms>
void GlassPass::drawPanes(const FrameContext& frame, const BodyTiles& tiles, const Program& program, Target into,
                          SetUniforms&& setUniforms) const {
    frame.targets.framebuffer({&frame.targets.at(into)}, &frame.targets.at(Target::GlassDepth)).begin();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_EQUAL);
    program.use();
    tiles.bind(program, BodyTiles::Which::Glass);
    program.set("uHasReflections", int(ReflectionsPass::needed(frame)));
    program.set("uReflection", frame.targets.orNone(Target::Reflection));
    program.set("uDepth", frame.targets.at(Target::Depth));
    program.set("uGlassTint", frame.targets.at(Target::GlassTint));
    program.set("uGlassSurface", frame.targets.at(Target::GlassSurface));
    setUniforms();
    tiles.drawTiles(program, BodyTiles::Which::Glass, frame.emptyVertexArray);
    ++frame.stats.drawCalls;
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

bool GlassPass::drawLight(const FrameContext& frame, const BodyTiles& tiles) const {
    if (!m_light || tiles.empty(BodyTiles::Which::Glass)) return false;
    frame.targets.target(Target::PaneLight);
    drawPanes(frame, tiles, m_light, Target::PaneLight, [] {});
    return true;
}

void GlassPass::drawOver(const FrameContext& frame, const BodyTiles& tiles, bool hasLight) const {
    if (!m_over || tiles.empty(BodyTiles::Which::Glass)) return;
    const Texture& behind = frame.targets.copy(Target::Radiance, Target::BehindGlass);
    drawPanes(frame, tiles, m_over, Target::Radiance, [&] {
        m_over.set("uHasPaneLight", int(hasLight));
        m_over.set("uPaneLight", frame.targets.orNone(Target::PaneLight));
        m_over.set("uRefraction", int(frame.settings.refraction));
        m_over.set("uBackground", behind);
    });
}

}  // namespace rubble
