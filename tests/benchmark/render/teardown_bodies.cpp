#include "tests/benchmark/render/teardown_bodies.h"

#include "render/passes/gbuffer_pass.h"

namespace rubble::bench {

TeardownBodies::TeardownBodies(ShaderLibrary& shaders)
    : m_program(shaders.load("../tests/benchmark/render/shaders/teardown_body.frag",
                             "../tests/benchmark/render/shaders/teardown_body.vert")) {}

void TeardownBodies::draw(const FrameContext& frame, const std::vector<int>& order) {
    TargetPool& targets = frame.targets;
    const Texture& albedo = targets.target(Target::Albedo);
    const Texture& normal = targets.target(Target::Normal);
    const Texture& material = targets.target(Target::Material);
    const Texture& motion = targets.target(Target::Motion);
    const Texture& depth = targets.target(Target::Depth);
    if (m_depthSoFar.size() != depth.size()) m_depthSoFar = Texture(GL_R32F, depth.size());
    const Texture& depthBuffer = targets.target(Target::DepthBuffer);
    const Framebuffer& gbuffer = targets.framebuffer({&albedo, &normal, &material, &motion, &depth}, &depthBuffer);
    const float zero[4] = {0, 0, 0, 0}, sky[4] = {GBufferPass::kSkyDepth, 0, 0, 0}, farthest = 1.0f;
    targets.framebuffer({&m_depthSoFar}).begin();
    glClearBufferfv(GL_COLOR, 0, sky);
    gbuffer.begin();
    for (int i = 0; i < 4; ++i) glClearBufferfv(GL_COLOR, i, zero);
    glClearBufferfv(GL_COLOR, 4, sky);
    glClearBufferfv(GL_DEPTH, 0, &farthest);

    m_program.use();
    frame.scene.bodies().bind(m_program);
    m_program.set("uDepthSoFar", m_depthSoFar);
    glBindVertexArray(frame.emptyVertexArray.get());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    const GLint body = glGetUniformLocation(m_program.name(), "uBody");
    const size_t batch = order.size() / (kCopies + 1) + 1;
    for (size_t i = 0; i < order.size(); ++i) {
        m_grids[size_t(order[i])].bind(m_program);
        glUniform1i(body, order[i]);
        glDrawArrays(GL_TRIANGLES, 0, 36);
        ++frame.stats.drawCalls;
        if (i % batch != batch - 1) continue;
        glBindFramebuffer(GL_READ_FRAMEBUFFER, targets.framebuffer({&depth}).name());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, targets.framebuffer({&m_depthSoFar}).name());
        glBlitFramebuffer(0, 0, depth.size().x, depth.size().y, 0, 0, depth.size().x, depth.size().y,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gbuffer.begin();
    }
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace rubble::bench
