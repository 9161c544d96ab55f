#include "render/passes/ropes_pass.h"

#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr int kSegments = 4;  ///< straight ones, drawn between two points of a rope

/// The Catmull-Rom spline between points i and i + 1; t in [0, 1].
glm::dvec3 spline(const std::vector<glm::dvec3>& points, size_t i, double t) {
    const glm::dvec3 &b = points[i], &c = points[i + 1];
    const glm::dvec3 a = i > 0 ? points[i - 1] : b * 2.0 - c, d = i + 2 < points.size() ? points[i + 2] : c * 2.0 - b;
    return 0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * (t * t) +
                  (3.0 * b - a - 3.0 * c + d) * (t * t * t));
}

}  // namespace

RopesPass::RopesPass(ShaderLibrary& shaders)
    : m_program(shaders.load("passes/ropes.frag", "passes/ropes.vert", "ropes are not drawn")) {
    glBindVertexArray(m_vertexArray.get());
    for (GLuint i = 0; i < 5; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribDivisor(i, 1);
    }
    glBindVertexArray(0);
}

void RopesPass::fillInstances(const FrameContext& frame, float alpha) {
    std::swap(m_places, m_lastPlaces);
    m_places.clear();
    m_instances.clear();
    std::vector<glm::dvec3> points;
    for (const SnapshotRope& rope : frame.scene.ropes()) {
        points.clear();
        for (size_t i = 0; i < rope.current.size(); ++i)
            points.push_back(glm::mix(rope.previous[i], rope.current[i], double(alpha)));
        double along = 0.0;
        for (size_t i = 0; i + 1 < points.size(); ++i)
            for (int k = 0; k < kSegments; ++k) {
                const glm::dvec3 from = spline(points, i, double(k) / kSegments),
                                 to = spline(points, i, double(k + 1) / kSegments);
                m_places.push_back(from);
                m_places.push_back(to);
                const double next = along + glm::length(to - from);
                const glm::vec3 first(from - frame.scene.origin()), second(to - frame.scene.origin());
                m_instances.push_back({glm::vec4(first, float(along)), glm::vec4(second, float(next)),
                                       glm::vec4(first, rope.radius), glm::vec4(second, 0.0f),
                                       glm::vec4(rope.color, 1.0f)});
                along = next;
            }
    }
    if (m_lastPlaces.size() != m_places.size()) return;  // other ropes than in the last frame: they have no motion
    for (size_t i = 0; i < m_instances.size(); ++i) {
        Instance& instance = m_instances[i];
        instance.lastFrom = glm::vec4(glm::vec3(m_lastPlaces[2 * i] - frame.scene.origin()), instance.lastFrom.w);
        instance.lastTo = glm::vec4(glm::vec3(m_lastPlaces[2 * i + 1] - frame.scene.origin()), 0.0f);
    }
}

void RopesPass::draw(const FrameContext& frame, float alpha) {
    fillInstances(frame, alpha);
    if (m_instances.empty() || !m_program) return;
    TargetPool& targets = frame.targets;
    targets
        .framebuffer({&targets.at(Target::Albedo), &targets.at(Target::Normal), &targets.at(Target::Material),
                      &targets.at(Target::Motion), &targets.at(Target::Depth)},
                     &targets.at(Target::DepthBuffer))
        .begin();
    m_program.use();
    glBindVertexArray(m_vertexArray.get());
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_instances.size() * sizeof(Instance)), m_instances.data(),
                 GL_STREAM_DRAW);
    for (GLuint i = 0; i < 5; ++i)
        glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                              reinterpret_cast<const void*>(i * sizeof(glm::vec4)));
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, GLsizei(m_instances.size()));
    ++frame.stats.drawCalls;
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace rubble
