#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

constexpr NumberRange kCount{1, 4096};
constexpr NumberRange kRadius{0.0, 100.0};   ///< m
constexpr NumberRange kVelocity{-1e3, 1e3};  ///< m/s
constexpr NumberRange kSpread{0.0, 1e3};     ///< m/s
constexpr NumberRange kSize{1e-3, 10.0};     ///< m
constexpr NumberRange kGrowth{0.0, 10.0};    ///< m/s
constexpr NumberRange kOpacity{1e-3, 1.0};
constexpr NumberRange kGravity{-100.0, 100.0};  ///< m/s2
constexpr NumberRange kDrag{0.0, 100.0};        ///< 1/s
constexpr NumberRange kSpin{-100.0, 100.0};     ///< rad/s
constexpr NumberRange kStretch{0.0, 1.0};       ///< s
constexpr NumberRange kLife{0.02, 60.0};        ///< s

ParticleBurst readBurst(const rubble_particle_burst& given) {
    ParticleBurst burst;
    burst.kind = ParticleKind(readEnum(given.kind, RUBBLE_PARTICLE_EMBER, "burst->kind"));
    burst.count = uint32_t(readOrDefault(given.count, kCount, 1, "burst->count"));
    burst.position = readVector(given.position, "burst->position");
    burst.radius = readInRange(given.radius, kRadius, "burst->radius");
    burst.velocity = readVector(given.velocity, "burst->velocity", kVelocity);
    burst.spread = float(readInRange(given.spread, kSpread, "burst->spread"));
    burst.color = readVector(given.color, "burst->color", ranges::kColor);
    burst.size = float(readOrDefault(given.size, kSize, 0.1, "burst->size"));
    burst.growth = float(readInRange(given.growth, kGrowth, "burst->growth"));
    burst.opacity = float(readOrDefault(given.opacity, kOpacity, 1.0, "burst->opacity"));
    burst.life = float(readOrDefault(given.life, kLife, 2.0, "burst->life"));
    burst.glow = float(readInRange(given.glow, ranges::kColor, "burst->glow"));
    burst.passes = readFlags(given.flags, RUBBLE_PARTICLE_PASSES, "burst->flags") & RUBBLE_PARTICLE_PASSES;
    burst.gravity = float(readInRange(given.gravity, kGravity, "burst->gravity"));
    burst.drag = float(readInRange(given.drag, kDrag, "burst->drag"));
    burst.spin = float(readInRange(given.spin, kSpin, "burst->spin"));
    burst.stretch = float(readInRange(given.stretch, kStretch, "burst->stretch"));
    return burst;
}

Particles* findParticles(HostedWorld& hosted) {
    Particles* particles = hosted.loop.drawingData().particles;
    if (!particles) refuse(RUBBLE_ERROR_ARGUMENT, "the world has no particles: create it with RUBBLE_WORLD_PARTICLES");
    return particles;
}

rubble_result spawnParticles(rubble_world world, const rubble_particle_burst* burst) {
    return inWorld("spawn_particles", world, [&](HostedWorld& hosted) {
        const ParticleBurst read = readBurst(readStruct(burst, "burst"));
        Particles* particles = findParticles(hosted);
        if (!isRefused()) particles->spawn(read, hosted.loop.world());
    });
}

rubble_particle particleRow(const SnapshotParticle& particle) {
    rubble_particle row = {};
    writeVector(row.position, particle.position);
    for (int i = 0; i < 3; ++i) row.velocity[i] = particle.velocity[i], row.color[i] = particle.color[i];
    row.radius = particle.radius;
    row.opacity = particle.opacity;
    row.age = particle.age;
    row.kind = uint32_t(particle.kind);
    row.seed = particle.seed;
    return row;
}

rubble_result getParticles(rubble_world world, rubble_particle* out, uint32_t capacity, uint32_t* count) {
    return inWorld("get_particles", world, [&](HostedWorld& hosted) {
        RowWriter<rubble_particle> rows(out, capacity, count);
        const Particles* particles = findParticles(hosted);
        if (isRefused()) return;
        for (const SnapshotParticle& each : particles->snapshot()) rows.add([&] { return particleRow(each); });
        rows.finish();
    });
}

}  // namespace

void setParticleFunctions(rubble_api& api) {
    api.spawn_particles = spawnParticles;
    api.get_particles = getParticles;
}

}  // namespace rubble::abi
