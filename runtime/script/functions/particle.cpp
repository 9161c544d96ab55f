#include <algorithm>
#include <cmath>

#include "runtime/script/binding/calls.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

rubble_particle_burst& burstOf(lua_State* L) {
    rubble_particle_burst& burst = ScriptContext::of(L).particle;
    if (burst.struct_size) return burst;
    burst = sized<rubble_particle_burst>();
    burst.kind = RUBBLE_PARTICLE_SMOKE;
    burst.size = 0.3;
    burst.opacity = 1.0;
    std::fill_n(burst.color, 3, 1.0);
    return burst;
}

int reset(lua_State* L) {
    ScriptContext::of(L).particle = {};
    return 0;
}

int setType(lua_State* L) {
    static constexpr const char* kNames[] = {"dust", "smoke", "flame", "spark", "crumb", "glint", "ember"};
    const std::string name = textAt(L, 1, "type");
    for (uint32_t kind = 0; kind < std::size(kNames); ++kind)
        if (name == kNames[kind] || (name == "plain" && kind == RUBBLE_PARTICLE_DUST)) {
            burstOf(L).kind = kind;
            return 0;
        }
    refuseArgument(L, 1, "type",
                   "\"plain\", \"dust\", \"smoke\", \"flame\", \"spark\", \"crumb\", \"glint\" or \"ember\"");
}

int setColor(lua_State* L) {
    const Vector color{clampedAt(L, 1, "r", 0.0, 1e6), clampedAt(L, 2, "g", 0.0, 1e6), clampedAt(L, 3, "b", 0.0, 1e6)};
    copy(burstOf(L).color, color);
    return 0;
}

int setRadius(lua_State* L) {
    const double first = clampedAt(L, 1, "r0", 0.001, 10.0);
    const double last = lua_isnoneornil(L, 2) ? first : clampedAt(L, 2, "r1", 0.0, 20.0);
    rubble_particle_burst& burst = burstOf(L);
    burst.size = first;
    burst.growth = std::clamp(last - first, 0.0, 10.0);  // of a whole life, until it is spawned
    return 0;
}

int setAlpha(lua_State* L) {
    burstOf(L).opacity = clampedAt(L, 1, "a0", 0.001, 1.0);
    return 0;
}

int setEmissive(lua_State* L) {
    burstOf(L).glow = clampedAt(L, 1, "e0", 0.0, 1e6);
    return 0;
}

int setGravity(lua_State* L) {
    burstOf(L).gravity = -clampedAt(L, 1, "g0", -100.0, 100.0);
    return 0;
}

int setDrag(lua_State* L) {
    burstOf(L).drag = clampedAt(L, 1, "d0", 0.0, 100.0);
    return 0;
}

int setRotation(lua_State* L) {
    burstOf(L).spin = clampedAt(L, 1, "r0", -100.0, 100.0);
    return 0;
}

int setStretch(lua_State* L) {
    burstOf(L).stretch = clampedAt(L, 1, "s0", 0.0, 1.0);
    return 0;
}

int setCollide(lua_State* L) {
    burstOf(L).flags = numberAt(L, 1, "c0") > 0.0 ? 0u : uint32_t(RUBBLE_PARTICLE_PASSES);
    return 0;
}

/// A vector whose components are brought into -most to most; not a number is an error.
Vector boundedAt(lua_State* L, int index, const char* name, double most) {
    Vector vector = vectorAt(L, index, name);
    for (double& component : vector) {
        if (std::isnan(component)) refuseArgument(L, index, name, "a vector of numbers");
        component = std::clamp(component, -most, most);
    }
    return vector;
}

int spawn(lua_State* L) {
    rubble_particle_burst burst = burstOf(L);
    copy(burst.position, boundedAt(L, 1, "pos", 1e9));
    copy(burst.velocity, boundedAt(L, 2, "vel", 1e3));
    burst.life = clampedAt(L, 3, "life", 0.02, 60.0);
    burst.growth = std::min(burst.growth / burst.life, 10.0);
    const rubble_result result = apiOf(L).spawn_particles(worldOf(L), &burst);
    if (result != RUBBLE_ERROR_ARGUMENT) isDone(L, result);
    return 0;
}

/// What particles of Teardown have and these do not.
int leaveOut(lua_State*) {
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"ParticleReset()", "Begins a particle of white smoke; what follows changes it.", reset},
    {"ParticleType(type)",
     "\"plain\", \"dust\", \"smoke\", \"flame\", \"spark\", \"crumb\", \"glint\" or \"ember\": how it moves and looks.",
     setType},
    {"ParticleColor(r, g, b)", "Its linear colour, 0 to 1.", setColor},
    {"ParticleRadius(r0, r1)", "Its radius at birth and at the end, in metres.", setRadius},
    {"ParticleAlpha(a0)", "Its opacity at birth, 0 to 1.", setAlpha},
    {"ParticleEmissive(e0)", "How much it glows.", setEmissive},
    {"ParticleGravity(g0)", "What pulls it up, or down where it is negative, in m/s2, beside what its type does.",
     setGravity},
    {"ParticleDrag(d0)", "How fast air takes its velocity, in 1/s.", setDrag},
    {"ParticleRotation(r0)", "How fast its image turns, in rad/s.", setRotation},
    {"ParticleStretch(s0)", "Seconds of its motion by which its image is longer, 0 to 1.", setStretch},
    {"ParticleCollide(c0)", "Whether voxels stop it: 0 not.", setCollide},
    {"ParticleTile(tile)", "No effect: its type says how it looks.", leaveOut},
    {"ParticleFlags(mask)", "No effect.", leaveOut},
    {"ParticleSticky(s0)", "No effect: what voxels stop lies there.", leaveOut},
    {"SpawnParticle(pos, vel, life)",
     "Throws one into the air for life seconds. Where nothing is drawn there are none.", spawn, 30},
};

}  // namespace

std::span<const ScriptFunction> particleFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
