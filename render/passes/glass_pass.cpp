#include "render/passes/glass_pass.h"

#include "render/scene/scene.h"

namespace rubble {

GlassPass::GlassPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/glass.frag", "passes/gbuffer.vert")) {
    glBindVertexArray(m_vertexArray.get());
    glBindBuffer(GL_ARRAY_BUFFER, m_orderBuffer.get());
    glEnableVertexAttribArray(0);
    glVertexAttribDivisor(0, 1);
    glVertexAttribIPointer(0, 1, GL_INT, 0, nullptr);
    glBindVertexArray(0);
}

void GlassPass::draw(const FrameContext& frame, const std::vector<int>& order) {
    const Texture& tint = frame.targets.target("glassTint", GL_RGBA8);
    const Texture& surface = frame.targets.target("glassSurface", GL_RGBA16F);
    frame.targets.framebuffer({&tint, &surface}).begin();
    const float clear[4] = {1, 1, 1, 1}, none[4] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, clear);
    glClearBufferfv(GL_COLOR, 1, none);

    const auto& instances = frame.scene.bodies().instances();
    m_farthestFirst.clear();
    for (auto body = order.rbegin(); body != order.rend(); ++body)
        if (instances[size_t(*body)].glass) m_farthestFirst.push_back(*body);
    if (!m_program || m_farthestFirst.empty()) return;
    m_program.use();
    frame.scene.bodies().bind(m_program);
    m_program.set("uDepth", frame.targets.at("depth"));
    glBindVertexArray(m_vertexArray.get());
    glBindBuffer(GL_ARRAY_BUFFER, m_orderBuffer.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_farthestFirst.size() * sizeof(int)), m_farthestFirst.data(), GL_STREAM_DRAW);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glEnablei(GL_BLEND, 0);  // panes multiply; of surfaces the nearest body's is written last and stays
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 36, GLsizei(m_farthestFirst.size()));
    ++frame.figures.drawCalls;
    ++frame.figures.bodyDraws;
    glDisablei(GL_BLEND, 0);
    glDisable(GL_CULL_FACE);
}

}  // namespace rubble
