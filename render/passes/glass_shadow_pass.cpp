#include "render/passes/glass_shadow_pass.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr int kSide = 512;         ///< texels
constexpr float kCell = 0.1f;      ///< metres per texel
constexpr float kStep = 4.0f;      ///< metres by which the map moves with the camera
constexpr float kHeight = 200.0f;  ///< metres toward the sun from the map's centre: no glass stands farther

}  // namespace

GlassShadowPass::GlassShadowPass(ShaderLibrary& shaders)
    : m_program(shaders.load("passes/glass_shadow.frag", "passes/glass_shadow.vert")),
      m_map(GL_RGBA16F, glm::ivec2(kSide)),
      m_framebuffer({&m_map}) {
    glBindVertexArray(m_vertexArray.get());
    glBindBuffer(GL_ARRAY_BUFFER, m_orderBuffer.get());
    glEnableVertexAttribArray(0);
    glVertexAttribDivisor(0, 1);
    glVertexAttribIPointer(0, 1, GL_INT, 0, nullptr);
    glBindVertexArray(0);
}

/// Places the map in front of the camera, in steps of kStep, so that it needs no redraw at every frame.
void GlassShadowPass::fitMap(const FrameContext& frame) {
    m_sun = glm::vec3(frame.block.sunDirection);
    m_right = glm::normalize(glm::cross(std::abs(m_sun.y) < 0.99f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), m_sun));
    m_up = glm::cross(m_sun, m_right);
    const glm::vec3 focus =
        glm::vec3(frame.block.cameraPosition) + glm::vec3(frame.block.cameraForward) * (0.3f * kSide * kCell);
    const glm::vec3 place =
        glm::floor(glm::vec3(glm::dot(focus, m_right), glm::dot(focus, m_up), glm::dot(focus, m_sun)) / kStep) * kStep;
    m_center = m_right * place.x + m_up * place.y + m_sun * place.z;
}

/// Lists the bodies with glass that the map covers.
void GlassShadowPass::listBodies(const FrameContext& frame) {
    m_bodies.clear();
    const auto& instances = frame.scene.bodies().instances();
    for (size_t i = 0; i < instances.size(); ++i) {
        const Bodies::Instance& body = instances[i];
        if (body.empty() || !body.glass) continue;
        const glm::vec3 low = glm::vec3(body.low) * body.voxelSize, high = glm::vec3(body.high) * body.voxelSize;
        const glm::vec3 offset = body.position + body.rotation * ((low + high) * 0.5f) - m_center;
        const float extent = 0.5f * (kSide * kCell + glm::length(high - low));
        if (std::abs(glm::dot(offset, m_right)) < extent && std::abs(glm::dot(offset, m_up)) < extent)
            m_bodies.push_back(int(i));
    }
}

void GlassShadowPass::draw(const FrameContext& frame) {
    const glm::vec3 before = m_center;
    fitMap(frame);
    if (!m_program || (m_drawnChanges == frame.scene.glassChanges() && before == m_center)) return;
    m_drawnChanges = frame.scene.glassChanges();
    listBodies(frame);
    m_framebuffer.begin();
    const float clear[4] = {1, 1, 1, 1e4f};  // no tint, no pane
    glClearBufferfv(GL_COLOR, 0, clear);
    if (m_bodies.empty()) return;
    m_program.use();
    frame.scene.bodies().bind(m_program);
    frame.scene.bindShadow(m_program);
    constexpr float kScale = 1.0f / (kSide * kCell);
    m_program.set("uRight", glm::vec4(m_right * kScale, 0.5f - glm::dot(m_right, m_center) * kScale));
    m_program.set("uUp", glm::vec4(m_up * kScale, 0.5f - glm::dot(m_up, m_center) * kScale));
    m_program.set("uMapCorner", m_center + m_sun * kHeight - (m_right + m_up) * (0.5f * kSide * kCell));
    m_program.set("uTexelRight", m_right * kCell);
    m_program.set("uTexelUp", m_up * kCell);
    m_program.set("uMapHeight", kHeight);
    glBindVertexArray(m_vertexArray.get());
    glBindBuffer(GL_ARRAY_BUFFER, m_orderBuffer.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_bodies.size() * sizeof(int)), m_bodies.data(), GL_STREAM_DRAW);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glEnable(GL_BLEND);
    glBlendEquationSeparate(GL_FUNC_ADD, GL_MIN);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 36, GLsizei(m_bodies.size()));
    ++frame.figures.drawCalls;
    ++frame.figures.bodyDraws;
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
}

void GlassShadowPass::bind(const Program& program) const {
    constexpr float kScale = 1.0f / (kSide * kCell);
    program.set("uGlassShadow", 1);
    program.set("uGlassShadowMap", m_map);
    program.set("uGlassShadowRight", glm::vec4(m_right * kScale, 0.5f - glm::dot(m_right, m_center) * kScale));
    program.set("uGlassShadowUp", glm::vec4(m_up * kScale, 0.5f - glm::dot(m_up, m_center) * kScale));
    program.set("uGlassShadowSun", glm::vec4(m_sun, -glm::dot(m_sun, m_center)));
}

}  // namespace rubble
