#include "render/passes/gbuffer_pass.h"

#include <algorithm>
#include <glm/common.hpp>

#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr float kSkyDepth = 65000.0f;  // as in lib/gbuffer.glsl

/// Where batch `i` of `batches` ends: the nearest bodies in batches of one, farther ones in larger and larger batches.
int batchEnd(int i, int batches, int bodies) {
    const double share = double(i + 1) / batches;
    return i + 1 == batches ? bodies : std::clamp(int(bodies * share * share), i + 1, bodies);
}

/// Planes through the camera, pointing inwards: left, right, bottom, top.
void sidePlanes(const FrameBlock& b, glm::vec3 out[4]) {
    const glm::vec3 forward(b.cameraForward), right(b.cameraRight), up(b.cameraUp);
    out[0] = glm::normalize(right + forward * b.cameraRight.w);
    out[1] = glm::normalize(-right + forward * b.cameraRight.w);
    out[2] = glm::normalize(up + forward * b.cameraUp.w);
    out[3] = glm::normalize(-up + forward * b.cameraUp.w);
}

}  // namespace

GBufferPass::GBufferPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/gbuffer.frag", "passes/gbuffer.vert")) {
    glBindVertexArray(m_vertexArray.get());
    glEnableVertexAttribArray(0);
    glVertexAttribDivisor(0, 1);
    glBindVertexArray(0);
}

void GBufferPass::sortBodies(const FrameContext& frame) {
    const auto& instances = frame.scene.bodies().instances();
    const glm::vec3 camera(frame.block.cameraPosition), forward(frame.block.cameraForward);
    glm::vec3 planes[4];
    sidePlanes(frame.block, planes);
    m_sorted.clear();
    for (size_t i = 0; i < instances.size(); ++i) {
        const Bodies::Instance& body = instances[i];
        if (body.empty()) continue;
        const glm::vec3 low = glm::vec3(body.low) * body.voxelSize, high = glm::vec3(body.high) * body.voxelSize;
        const glm::vec3 center = body.position + body.rotation * ((low + high) * 0.5f) - camera;
        const float radius = glm::length(high - low) * 0.5f;
        bool visible = glm::dot(center, forward) > -radius;
        for (const glm::vec3& plane : planes) visible &= glm::dot(center, plane) > -radius;
        if (!visible) continue;
        const glm::vec3 cameraLocal = glm::conjugate(body.rotation) * (camera - body.position);
        m_sorted.emplace_back(glm::distance(cameraLocal, glm::clamp(cameraLocal, low, high)), int(i));
    }
    std::sort(m_sorted.begin(), m_sorted.end());
    m_order.clear();
    for (const auto& [distance, body] : m_sorted) m_order.push_back(body);
}

void GBufferPass::drawBatch(const FrameContext& frame, int first, int count) const {
    glVertexAttribIPointer(0, 1, GL_INT, 0, reinterpret_cast<const void*>(size_t(first) * sizeof(int)));
    glDrawArraysInstanced(GL_TRIANGLES, 0, 36, count);
    ++frame.figures.drawCalls;
    ++frame.figures.bodyDraws;
}

void GBufferPass::draw(const FrameContext& frame) {
    TargetPool& targets = frame.targets;
    const Texture& albedo = targets.target("albedo", GL_RGBA8);
    const Texture& normal = targets.target("normal", GL_RGBA16F);
    const Texture& material = targets.target("material", GL_RGBA8);
    const Texture& motion = targets.target("motion", GL_RG16F);
    const Texture& depth = targets.target("depth", GL_R32F);
    const Texture& depthSoFar = targets.target("depthSoFar", GL_R32F);
    const Texture& depthBuffer = targets.target("depthBuffer", GL_DEPTH_COMPONENT32F);
    const Framebuffer& copyTarget = targets.framebuffer({&depthSoFar});
    const Framebuffer& copySource = targets.framebuffer({&depth});
    const Framebuffer& gbuffer = targets.framebuffer({&albedo, &normal, &material, &motion, &depth}, &depthBuffer);
    const float zero[4] = {0, 0, 0, 0}, sky[4] = {kSkyDepth, 0, 0, 0};
    copyTarget.begin();
    glClearBufferfv(GL_COLOR, 0, sky);
    gbuffer.begin();
    for (int i = 0; i < 4; ++i) glClearBufferfv(GL_COLOR, i, zero);
    glClearBufferfv(GL_COLOR, 4, sky);
    const float farthest = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &farthest);

    sortBodies(frame);
    if (!m_program || m_order.empty()) return;
    m_program.use();
    frame.scene.bodies().bind(m_program);
    m_program.set("uDepthSoFar", depthSoFar);
    glBindVertexArray(m_vertexArray.get());
    glBindBuffer(GL_ARRAY_BUFFER, m_orderBuffer.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_order.size() * sizeof(int)), m_order.data(), GL_STREAM_DRAW);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);  // the camera may be inside a box: its back faces are always there
    const int bodies = int(m_order.size()), batches = std::min(bodies, kMaxDraws);
    for (int i = 0, first = 0; i < batches; ++i) {
        const int end = batchEnd(i, batches, bodies);
        drawBatch(frame, first, end - first);
        first = end;
        if (i + 1 == batches) break;
        glBindFramebuffer(GL_READ_FRAMEBUFFER, copySource.name());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, copyTarget.name());
        glBlitFramebuffer(0, 0, depth.size().x, depth.size().y, 0, 0, depth.size().x, depth.size().y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gbuffer.begin();
    }
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

void GBufferPass::bind(const Program& program, const TargetPool& targets) {
    program.set("uAlbedo", targets.at("albedo"));
    program.set("uNormal", targets.at("normal"));
    program.set("uMaterial", targets.at("material"));
    program.set("uMotion", targets.at("motion"));
    program.set("uDepth", targets.at("depth"));
}

}  // namespace rubble
