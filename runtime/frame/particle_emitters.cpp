#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "runtime/frame/particles.h"
#include "runtime/world/queries/query.h"

namespace rubble {
namespace {

constexpr double kFloorSearchDepth = 60.0;  ///< metres: how far below a place ground is searched
constexpr int kMaxStackedBodies = 12;       ///< free bodies that the search passes through
constexpr double kMinBodyThickness = 0.15;  ///< metres below the top of each from which the search goes on
constexpr double kFloorCacheRadius = 0.4;   ///< metres: events this near each other share one search
constexpr int kFlamesPerStep = 30;          ///< of all fires together
constexpr int kSmokePerStep = 4;
constexpr int kEmbersPerStep = 5;
constexpr float kBlazeFires = 90.0f;         ///< number of fires from which on flames have their full height
constexpr float kBlastGlow = 6.0f;           ///< radiant intensity of a flame of an explosion of size 1
constexpr float kSparkGlow = 0.08f;          ///< the same of a spark
constexpr double kSolidShare = 0.6;          ///< of the budget, for solid particles: the rest is for gas and fire
constexpr double kImpactPuff = 1500;         ///< N s above which an impact raises dust
constexpr double kMaxImpactStrength = 10.0;  ///< of sqrt(impulse / 4 kN s): above it the dust does not grow
constexpr double kMaxDustHeight = 1.5;       ///< metres over the ground, above which it raises none
constexpr double kMinLevelNormal = 0.5;      ///< y of the normal of a face that is level enough for dust

/// What each voxel of a material throws up: how much of it becomes dust, and which solid particles fly.
struct Emission {
    float dust = 0.6f;
    ParticleKind solid = ParticleKind::Crumb;
    float solids = 0.5f;  ///< for each voxel, before the budget
};
Emission emissionOf(const Material& material) {
    if (material.fragments == "pane") return {0.03f, ParticleKind::Glint, 1.6f};
    if (material.fragments == "tear") return {0.12f, ParticleKind::Spark, 0.9f};
    if (material.fragments == "splinter") return {0.40f, ParticleKind::Crumb, 0.9f};
    if (material.fragments == "crumble") return {1.0f, ParticleKind::Crumb, 0.5f};
    return {0.8f, ParticleKind::Crumb, 0.6f};
}

glm::vec3 linear(std::array<uint8_t, 3> color) {
    return {srgbToLinear(color[0]), srgbToLinear(color[1]), srgbToLinear(color[2])};
}

}  // namespace

glm::vec3 Particles::anyDirection() {
    // Directions to the cube's corners are a little more likely, which does not show.
    const float x = m_random.unit() * 2.0f - 1.0f;
    const float y = m_random.unit() * 2.0f - 1.0f;
    const float z = m_random.unit() * 2.0f - 1.0f;
    return glm::vec3(x, y, z) / std::max(0.3f, std::sqrt(x * x + y * y + z * z));
}

int Particles::share(double wanted, double ofBudget) {
    const double room = 1.0 - double(m_alive.size()) / (ofBudget * double(m_settings.maxAlive));
    return int(wanted * std::clamp(room * 1.6, 0.0, 1.0) + double(m_random.unit()));
}

void Particles::add(const Particle& particle) {
    if (m_alive.size() < m_settings.maxAlive) m_alive.push_back(particle);
}

double Particles::floorBelow(glm::dvec3 position, const World& world) {
    if (glm::distance(position, m_floorQuery) < kFloorCacheRadius) return m_floorFound;
    m_floorQuery = position;
    m_floorFound = position.y - kFloorSearchDepth;
    // Free bodies do not count: they may have moved on before something lands.
    glm::dvec3 from = position;
    for (int i = 0; i < kMaxStackedBodies; ++i) {
        const WorldHit hit = castRay(world, {from, {0, -1, 0}, kFloorSearchDepth});
        if (!hit.hit) break;
        if (!hit.shape || world.bodies().at(world.shapes().at(hit.shape).body).isStatic) {
            m_floorFound = hit.position.y;
            break;
        }
        from.y = hit.position.y - kMinBodyThickness;
    }
    return m_floorFound;
}

void Particles::addDust(const DustCloud& cloud, const World& world) {
    const Emission emission = emissionOf(world.materials()[cloud.material]);
    const double floor = floorBelow(cloud.position, world);
    const double voxels = double(cloud.count), spread = std::clamp(cloud.radius, 0.05, 2.5);
    const glm::vec3 color = linear(cloud.color);
    const int puffs = share(std::min((0.10 * std::sqrt(voxels) + 0.006 * voxels) * double(emission.dust), 10.0));
    for (int i = 0; i < puffs; ++i) {
        const glm::vec3 direction = anyDirection();
        Particle p{ParticleKind::Dust};
        p.position = cloud.position + glm::dvec3(direction) * (spread * double(between(0.2f, 0.9f)));
        p.velocity = cloud.velocity * 0.6f + direction * between(0.4f, 1.6f) * float(1.0 + spread);
        p.color = glm::mix(color, glm::vec3(0.42f, 0.38f, 0.33f), 0.5f) * between(0.85f, 1.15f);
        p.radius = float(0.12 + 0.22 * spread) * between(0.7f, 1.3f);
        p.growth = between(0.45f, 0.9f);
        p.opacity = between(0.5f, 0.9f);
        p.life = between(1.4f, 3.2f);
        p.floor = floor;
        p.seed = m_random.next();
        add(p);
    }
    const double maxAlive =
        emission.solid == ParticleKind::Glint ? 9.0 * std::sqrt(voxels) : 4.0 + 2.2 * std::sqrt(voxels);
    const int solids = share(std::min(voxels * double(emission.solids), maxAlive) * 0.8, kSolidShare);
    for (int i = 0; i < solids; ++i) {
        const glm::vec3 direction = anyDirection();
        const bool spark = emission.solid == ParticleKind::Spark && m_random.below(3) != 0;
        Particle p{emission.solid == ParticleKind::Spark && !spark ? ParticleKind::Crumb : emission.solid};
        p.position = cloud.position + glm::dvec3(direction) * (spread * double(m_random.unit()));
        p.velocity = cloud.velocity + direction * between(0.6f, spark ? 7.0f : 3.6f) +
                     glm::vec3(0.0f, between(0.2f, 2.2f), 0.0f);
        p.color = spark ? glm::vec3(1.0f, 0.62f, 0.22f) : color * between(0.8f, 1.2f);
        p.radius = spark ? 0.012f : p.kind == ParticleKind::Glint ? between(0.02f, 0.05f) : between(0.014f, 0.042f);
        p.growth = 0.0f;
        p.opacity = 1.0f;
        p.life = spark ? between(0.25f, 0.8f) : between(1.2f, 4.0f);
        p.glow = spark ? kSparkGlow : 0.0f;
        p.floor = floor;
        p.seed = m_random.next();
        add(p);
    }
}

void Particles::spawn(const ParticleBurst& burst, const World& world) {
    m_floorQuery = glm::dvec3(1e30);  // the world may have changed since the last step
    const double floor = m_settings.maxAlive && !burst.passes ? floorBelow(burst.position, world) : 0.0;
    for (uint32_t i = 0; i < burst.count && m_alive.size() < m_settings.maxAlive; ++i) {
        Particle p{burst.kind};
        p.position = burst.position + glm::dvec3(anyDirection()) * (burst.radius * double(m_random.unit()));
        p.velocity = burst.velocity + anyDirection() * (burst.spread * m_random.unit());
        p.color = burst.color;
        p.radius = burst.size;
        p.growth = burst.growth;
        p.opacity = burst.opacity;
        p.life = burst.life;
        p.glow = burst.glow;
        p.floor = burst.passes ? -std::numeric_limits<double>::infinity() : floor;
        p.seed = m_random.next();
        p.gravity = burst.gravity;
        p.drag = burst.drag;
        p.spin = burst.spin;
        p.stretch = burst.stretch;
        add(p);
    }
}

void Particles::addBlast(const Blast& blast, const World& world) {
    const double floor = floorBelow(blast.position, world);
    const float size = float(blast.size);
    const auto puff = [&](ParticleKind kind, glm::vec3 color, float speed, float radius, float growth, float opacity,
                          float life) {
        const glm::vec3 direction = anyDirection();
        Particle p{kind};
        p.position = blast.position + glm::dvec3(direction) * double(size * between(0.1f, 0.5f));
        p.velocity = direction * speed * between(0.5f, 1.2f);
        p.color = color * between(0.85f, 1.15f);
        p.radius = radius * between(0.7f, 1.3f);
        p.growth = growth;
        p.opacity = opacity;
        p.life = life * between(0.6f, 1.3f);
        p.glow = kind == ParticleKind::Flame   ? kBlastGlow * size * size
                 : kind == ParticleKind::Spark ? kSparkGlow
                                               : 0.0f;
        p.floor = floor;
        p.seed = m_random.next();
        add(p);
    };
    for (int i = share(8.0 + 8.0 * size); i > 0; --i)
        puff(ParticleKind::Flame, glm::vec3(1.0f), 4.0f * size, 0.34f * size, 0.8f * size, 0.9f, 0.38f);
    for (int i = share(6.0 + 7.0 * size); i > 0; --i)
        puff(ParticleKind::Smoke, glm::vec3(0.10f, 0.092f, 0.085f), 3.4f * size, 0.34f * size, 0.75f, 0.65f, 3.2f);
    for (int i = share(10.0 + 10.0 * size); i > 0; --i)
        puff(ParticleKind::Spark, glm::vec3(1.0f, 0.6f, 0.22f), 9.0f * size, 0.014f, 0.0f, 1.0f, 0.7f);
}

void Particles::addImpact(const Impact& impact, const World& world) {
    if (!(impact.impulse > kImpactPuff) || std::abs(impact.normal.y) < kMinLevelNormal) return;
    const double floor = floorBelow(impact.position + glm::dvec3(0, 0.3, 0), world);
    if (impact.position.y > floor + kMaxDustHeight) return;
    const double strength = std::min(std::sqrt(impact.impulse / 4000.0), kMaxImpactStrength);
    const float size = float(strength);
    for (int i = share(1.0 + 4.0 * strength); i > 0; --i) {
        glm::vec3 direction = anyDirection();
        direction.y = std::abs(direction.y) * 0.5f;
        Particle p{ParticleKind::Dust};
        // A long body lands along its length, but physics reports one contact for a pair of bodies. So the dust of a
        // stronger impact is spread farther around it.
        const double spread = 0.1 + 0.05 * strength * strength * double(m_random.unit());
        p.position = {impact.position.x + double(direction.x) * spread, impact.position.y + 0.2 * double(direction.y),
                      impact.position.z + double(direction.z) * spread};
        p.velocity = direction * (between(0.8f, 2.4f) * std::min(size, 1.5f + 0.4f * size));
        p.color = glm::vec3(0.36f, 0.33f, 0.29f) * between(0.85f, 1.15f);
        p.radius = 0.14f + 0.1f * size;
        p.growth = between(0.4f, 0.8f) * (1.0f + 0.1f * size);
        p.opacity = between(0.3f, 0.5f) + 0.02f * size;
        p.life = between(1.2f, 2.6f) * (1.0f + 0.12f * size);
        p.floor = floor;
        p.seed = m_random.next();
        add(p);
    }
}

/// Fires take turns, so that many cost no more than a few and none is left out.
void Particles::addFires(std::span<const Fire> fires) {
    const auto lit = [&](const Fire& fire, ParticleKind kind) {
        const glm::vec3 direction = anyDirection();
        Particle p{kind};
        p.position = fire.position + glm::dvec3(direction) * double(float(fire.radius) * 0.8f);
        p.floor = p.position.y - kFloorSearchDepth;
        p.seed = m_random.next();
        return p;
    };
    const int count = int(fires.size());
    const int flames = std::min(kFlamesPerStep, (count * 2 + 2) / 3),
              smokes = std::min(kSmokePerStep, (count + 11) / 12);
    const float blaze = std::min(float(count) / kBlazeFires, 1.0f);  // fires near each other burn higher
    for (int i = 0; i < flames; ++i) {
        const Fire& fire = fires[size_t(m_nextFire++ % uint32_t(count))];
        if (m_random.unit() > fire.intensity) continue;
        Particle p = lit(fire, ParticleKind::Flame);
        p.velocity = glm::vec3(between(-0.3f, 0.3f), between(0.5f, 1.5f), between(-0.3f, 0.3f));
        p.color = glm::vec3(1.0f);
        p.radius = float(fire.radius) * between(0.6f, 1.1f) * (1.0f + 0.9f * blaze);
        p.growth = -0.25f * p.radius;
        p.opacity = 0.5f + 0.5f * fire.intensity;
        p.life = between(0.6f, 1.1f);
        add(p);
    }
    for (int i = share(kEmbersPerStep * double(blaze)); i > 0; --i) {
        const Fire& fire = fires[size_t(m_random.below(uint32_t(count)))];
        Particle p = lit(fire, ParticleKind::Ember);
        p.velocity = glm::vec3(between(-0.8f, 0.8f), between(1.5f, 4.0f), between(-0.8f, 0.8f));
        p.color = glm::vec3(1.0f, 0.36f, 0.08f) * between(0.5f, 1.2f);
        p.radius = between(0.010f, 0.028f);
        p.growth = 0.0f;
        p.opacity = 1.0f;
        p.life = between(1.5f, 4.0f);
        add(p);
    }
    for (int i = 0; i < smokes; ++i) {
        const Fire& fire = fires[size_t(m_random.below(uint32_t(count)))];
        if (m_random.unit() > 1.0f - 0.6f * fire.intensity) continue;  // weak fires smoke most
        Particle p = lit(fire, ParticleKind::Smoke);
        p.position.y += 0.8;  // it forms over the flames
        p.velocity = glm::vec3(between(-0.2f, 0.2f), between(1.8f, 3.0f), between(-0.2f, 0.2f));
        p.color = glm::vec3(0.045f, 0.043f, 0.041f) * between(0.6f, 1.8f);
        p.radius = float(fire.radius) * between(0.6f, 0.9f);
        p.growth = between(0.35f, 0.6f);
        p.opacity = between(0.35f, 0.65f);
        p.life = between(4.0f, 7.0f);
        add(p);
    }
}

}  // namespace rubble
