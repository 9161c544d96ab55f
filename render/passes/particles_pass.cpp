#include "render/passes/particles_pass.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "render/gl/draw_state.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"
#include "render/scene/water_area.h"
#include "runtime/core/constants.h"
#include "runtime/core/random.h"

namespace rubble {
namespace {

constexpr const char* kVertexShader = "passes/particles.vert";
constexpr const char* kNoParticles = "particles are not drawn";
constexpr int kNoiseSize = 128;  ///< texels
constexpr float kStepSeconds = 1.0f / float(kStepsPerSecond);
constexpr GLuint kParticleAttributes = 5;  ///< of an instance: vectors of four floats
constexpr int kLights = 4;  ///< local lights that light particles: the strongest at the particles' mean position

/// Tileable value noise of 4 octaves, in [0, 1].
float puffNoise(int x, int y) {
    float sum = 0.0f, weight = 0.5f;
    for (int period = 4; period <= 32; period *= 2, weight *= 0.5f) {
        const int step = kNoiseSize / period;
        const auto at = [&](int dx, int dy) {
            return float(hashCell((x / step + dx) % period, (y / step + dy) % period, period, 201) >> 8) * 0x1p-24f;
        };
        float fx = float(x % step) / float(step), fy = float(y % step) / float(step);
        fx = fx * fx * (3.0f - 2.0f * fx);
        fy = fy * fy * (3.0f - 2.0f * fy);
        const float low = at(0, 0) + (at(1, 0) - at(0, 0)) * fx, high = at(0, 1) + (at(1, 1) - at(0, 1)) * fx;
        sum += weight * (low + (high - low) * fy);
    }
    return std::clamp(sum / 0.9375f, 0.0f, 1.0f);
}

/// The texture that makes a disc look like a puff: r noise, gb its slope along x and y plus one half.
std::vector<uint8_t> makePuffTexture() {
    std::vector<uint8_t> out;
    out.reserve(size_t(kNoiseSize) * kNoiseSize * 4);
    const auto byte = [](float value) { return uint8_t(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f); };
    for (int y = 0; y < kNoiseSize; ++y)
        for (int x = 0; x < kNoiseSize; ++x) {
            constexpr int kSlopeOffset = 4;
            const float here = puffNoise(x, y), right = puffNoise((x + kSlopeOffset) % kNoiseSize, y),
                        above = puffNoise(x, (y + kSlopeOffset) % kNoiseSize);
            for (const float value : {here, 0.5f + right - here, 0.5f + above - here, 1.0f}) out.push_back(byte(value));
        }
    return out;
}

/// A random number in [0, 1) from ten bits of a seed.
float fraction(uint32_t seed, int shift) {
    return float(seed >> shift & 1023u) / 1024.0f;
}

}  // namespace

ParticlesPass::ParticlesPass(ShaderLibrary& shaders)
    : m_solids(shaders.load("passes/particle_solids.frag", kVertexShader, kNoParticles)),
      m_soft(shaders.load("passes/particle_soft.frag", kVertexShader, kNoParticles)),
      m_noise(GL_RGBA8, glm::ivec2(kNoiseSize), Filter::Linear, Wrap::Repeat) {
    m_noise.upload(makePuffTexture().data());
    glBindVertexArray(m_vertexArray.get());
    for (GLuint i = 0; i < kParticleAttributes; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribDivisor(i, 1);
    }
    glBindVertexArray(0);
}

void ParticlesPass::sortInstances(const FrameContext& frame, float alpha) {
    const auto& particles = frame.scene.particles();
    const glm::vec3 camera(frame.block.cameraPosition), forward(frame.block.cameraForward);
    // From under water the surface shows no particles above it: rays that it sends do not meet them.
    const double top = waterSurfaceOver(frame.scene.waters(), glm::dvec3(camera) + frame.scene.origin()).value_or(1e9);
    for (auto* order : {&m_solidOrder, &m_softOrder}) order->clear();
    m_instances.clear();
    for (size_t i = 0; i < particles.size(); ++i) {
        const SnapshotParticle& p = particles[i];
        const float depth = glm::dot(glm::vec3(p.position - frame.scene.origin()) - camera, forward);
        auto& order = p.kind == ParticleKind::Crumb || p.kind == ParticleKind::Glint ? m_solidOrder : m_softOrder;
        if (depth > -p.radius && p.position.y < top) order.emplace_back(-depth, int(i));
    }
    for (auto* order : {&m_solidOrder, &m_softOrder}) {
        std::sort(order->begin(), order->end());
        for (const auto& [depth, i] : *order) {
            const SnapshotParticle& p = particles[size_t(i)];
            const glm::vec3 position =
                glm::vec3(p.position - frame.scene.origin()) - p.velocity * (kStepSeconds * (1.0f - alpha));
            m_instances.push_back({glm::vec4(position, p.radius), glm::vec4(p.color, p.opacity),
                                   glm::vec4(p.velocity, float(p.kind)),
                                   glm::vec4(p.age, fraction(p.seed, 0), fraction(p.seed, 10), fraction(p.seed, 20)),
                                   glm::vec4(p.turn, p.stretch, 0.0f, 0.0f)});
        }
    }
}

void ParticlesPass::setLights(const FrameContext& frame, const Program& program) const {
    glm::vec3 middle(0.0f);
    for (const Instance& instance : m_instances) middle += glm::vec3(instance.place);
    middle /= float(m_instances.size());
    std::vector<std::pair<float, const SnapshotLight*>> strongest;
    for (const SnapshotLight& light : frame.scene.lights()) {
        const glm::vec3 away = glm::vec3(light.position - frame.scene.origin()) - middle;
        strongest.emplace_back(-(light.color.x + light.color.y + light.color.z) / (1.0f + glm::dot(away, away)),
                               &light);
    }
    const size_t count = std::min<size_t>(kLights, strongest.size());
    std::partial_sort(strongest.begin(), strongest.begin() + ptrdiff_t(count), strongest.end());
    static constexpr std::array kPlaces = {"uLightPosition0", "uLightPosition1", "uLightPosition2", "uLightPosition3"};
    static constexpr std::array kColors = {"uLightColor0", "uLightColor1", "uLightColor2", "uLightColor3"};
    for (size_t i = 0; i < kLights; ++i) {
        const SnapshotLight* light = i < count ? strongest[i].second : nullptr;
        program.set(kPlaces[i], light ? glm::vec4(glm::vec3(light->position - frame.scene.origin()), light->reach)
                                      : glm::vec4(0, 0, 0, 1));
        program.set(kColors[i], light ? light->color : glm::vec3(0.0f));
    }
}

void ParticlesPass::drawRange(const FrameContext& frame, const Program& program, size_t first, size_t last) const {
    if (first == last || !program) return;
    program.use();
    frame.scene.bindShadow(program);
    frame.scene.bindSmoke(program);
    program.set("uDepth", frame.targets.at(Target::Depth));
    program.set("uPuffNoise", m_noise);
    program.set("uBlueNoise", frame.blueNoise);
    setLights(frame, program);
    for (GLuint i = 0; i < kParticleAttributes; ++i)
        glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                              reinterpret_cast<const void*>(first * sizeof(Instance) + i * sizeof(glm::vec4)));
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, GLsizei(last - first));
    ++frame.stats.drawCalls;
}

void ParticlesPass::draw(const FrameContext& frame, float alpha) {
    sortInstances(frame, alpha);
    if (m_instances.empty()) return;
    frame.targets.framebuffer({&frame.targets.at(Target::Radiance)}, &frame.targets.at(Target::DepthBuffer)).begin();
    glBindVertexArray(m_vertexArray.get());
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.get());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_instances.size() * sizeof(Instance)), m_instances.data(),
                 GL_STREAM_DRAW);
    // The depth test only saves work: quads stand at the near side of their particle, and the shader fades them out
    // where they go behind a surface.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    setBlend({GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA});
    drawRange(frame, m_solids, 0, m_solidOrder.size());
    drawRange(frame, m_soft, m_solidOrder.size(), m_instances.size());
    disableBlend();
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace rubble
