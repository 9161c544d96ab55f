#include "runtime/frame/particles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "runtime/core/constants.h"

namespace rubble {
namespace {

constexpr float kStep = 1.0f / float(kStepsPerSecond);  ///< s
constexpr float kGravity = 9.81f;                       ///< m/s2
constexpr float kBounce = 0.35f;  ///< speed of solid particles after they hit the ground, over that before

/// How a kind of particle moves: drag as a share of its velocity per second, weight as a share of gravity, buoyancy and
/// eddies in m/s2.
struct Motion {
    float drag, weight, rise, eddies;
};
Motion motionOf(ParticleKind kind) {
    switch (kind) {
        case ParticleKind::Dust:
            return {2.6f, 0.0f, 0.10f, 0.5f};
        case ParticleKind::Smoke:
            return {1.1f, 0.0f, 1.5f, 0.9f};
        case ParticleKind::Flame:
            return {1.6f, 0.0f, 3.4f, 2.2f};
        case ParticleKind::Spark:
            return {0.7f, 1.0f, 0.0f, 0.0f};
        case ParticleKind::Crumb:
            return {0.25f, 1.0f, 0.0f, 0.0f};
        case ParticleKind::Glint:
            return {0.5f, 1.0f, 0.0f, 0.0f};
        case ParticleKind::Ember:
            return {0.8f, 0.0f, 1.3f, 3.5f};
    }
    return {};
}

/// Slow turbulence: a divergence-free field of sines, so that plumes curl and keep their volume.
glm::vec3 eddy(glm::dvec3 at, float time) {
    const float x = float(std::fmod(at.x, 1000.0)), y = float(std::fmod(at.y, 1000.0)),
                z = float(std::fmod(at.z, 1000.0));
    return {std::sin(1.3f * y + 0.7f * time) + std::cos(1.9f * z), 0.5f * std::sin(1.5f * x + 1.1f * z + time),
            std::cos(1.7f * x - 0.5f * time) + std::sin(1.1f * y)};
}

bool isSolid(ParticleKind kind) {
    return kind == ParticleKind::Crumb || kind == ParticleKind::Glint || kind == ParticleKind::Spark;
}

/// Opacity at a share of the particle's life: it fades in fast and out slowly. Of solid particles: size, which shrinks
/// at the very end.
float presence(ParticleKind kind, float share) {
    if (isSolid(kind)) return std::min(1.0f, (1.0f - share) * 5.0f);
    const float in = kind == ParticleKind::Dust ? 0.03f : 0.12f;
    return std::min(share / in, 1.0f) * (1.0f - share) * (kind == ParticleKind::Smoke ? 1.0f : 1.0f - share);
}

}  // namespace

void Particles::move(Particle& p) const {
    const Motion motion = motionOf(p.kind);
    p.age += kStep;
    if (p.kind != ParticleKind::Spark) {
        // Drag slows a puff down while it grows.
        p.velocity -=
            (p.velocity - (isSolid(p.kind) ? glm::vec3(0.0f) : m_settings.wind)) * std::min(1.0f, motion.drag * kStep);
        if (motion.eddies > 0.0f) p.velocity += eddy(p.position, p.age + float(p.seed % 64)) * (motion.eddies * kStep);
    }
    p.velocity *= 1.0f - std::min(1.0f, p.drag * kStep);
    p.velocity.y += (motion.rise - kGravity * motion.weight - p.gravity) * kStep;
    p.position += glm::dvec3(p.velocity) * double(kStep);
    const double lowest = p.floor + (isSolid(p.kind) ? double(p.radius) : 0.35 * double(p.radius + p.growth * p.age));
    if (p.position.y >= lowest || p.velocity.y >= 0.0f) return;
    p.position.y = lowest;
    p.velocity *= isSolid(p.kind) ? glm::vec3(0.6f, -kBounce, 0.6f) : glm::vec3(1.0f, 0.0f, 1.0f);
    if (p.velocity.y < 0.4f && isSolid(p.kind)) p.velocity = glm::vec3(p.velocity.x * 0.5f, 0.0f, p.velocity.z * 0.5f);
}

void Particles::step(const FrameChanges& changes, std::span<const Impact> impacts, std::span<const Fire> fires,
                     const World& world) {
    if (m_settings.maxAlive == 0) return;
    if (changes.levelReplaced || changes.isRestored) clear();
    if (changes.isStill) return;
    for (Particle& particle : m_alive) move(particle);
    std::erase_if(m_alive, [](const Particle& particle) { return particle.age >= particle.life; });
    m_floorQuery = glm::dvec3(1e30);  // the world has changed since the last step
    for (const Blast& blast : changes.blasts) addBlast(blast, world);
    for (const DustCloud& cloud : changes.dust) addDust(cloud, world);
    for (const Impact& impact : impacts) addImpact(impact, world);
    if (!fires.empty()) addFires(fires);
}

std::vector<SnapshotParticle> Particles::snapshot() const {
    std::vector<SnapshotParticle> out;
    out.reserve(m_alive.size());
    for (const Particle& p : m_alive) {
        const float share = p.age / p.life, left = presence(p.kind, share);
        const float size = p.radius + p.growth * p.age * (isSolid(p.kind) ? 0.0f : 1.0f / (1.0f + 0.35f * p.age));
        out.push_back({p.kind, p.position, p.velocity, p.color, isSolid(p.kind) ? size * left : size,
                       isSolid(p.kind) ? p.opacity : p.opacity * left, share, p.seed, p.spin * p.age, p.stretch});
    }
    return out;
}

}  // namespace rubble
