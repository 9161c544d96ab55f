#include "runtime/plugin/character_reports.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "runtime/core/constants.h"
#include "runtime/world/queries/query.h"

namespace rubble {
namespace {

constexpr double kLandingSpeed = 1.0;  ///< m/s downward; what is slower is a step down a stair
constexpr double kFeet = 0.3;          ///< metres over and under the feet in which the ground is searched
constexpr double kCapsuleShare = 0.9;  ///< of its radius, so that walls beside it are not touched

/// The ground under the middle of the feet, or else, at an edge, under the capsule.
Footstep footstepAt(const CharacterMove& move, const World& world) {
    Footstep out{.character = move.character, .position = move.position};
    const Character& character = world.characters().at(move.character);
    QueryFilter filter;
    filter.rejectUnphysical = true;
    filter.layerMask = character.collisionMask;
    RayQuery down{move.position + glm::dvec3(0.0, kFeet, 0.0), {0.0, -1.0, 0.0}, 2.0 * kFeet};
    WorldHit hit = castRay(world.data(), down, filter);
    if (!hit.hit) {
        down.radius = kCapsuleShare * character.radius;
        down.origin.y += down.radius;
        hit = castRay(world.data(), down, filter);
    }
    if (!hit.shape) return out;
    out.shape = hit.shape;
    out.material = (*world.shapes().at(hit.shape).palette)[hit.entry].material;
    return out;
}

}  // namespace

void CharacterReports::walk(const CharacterMove& move, Seen& seen, const World& world, double stride) {
    if (!move.grounded) return;
    const double speed = std::hypot(move.velocity.x, move.velocity.z);
    const bool landed = !seen.grounded && seen.fallSpeed > kLandingSpeed;
    seen.walked += speed / double(kStepsPerSecond);
    if (!landed && seen.walked < stride) return;
    seen.walked = landed ? 0.0 : std::fmod(seen.walked, stride);
    m_footsteps.push_back(footstepAt(move, world));
    m_footsteps.back().landed = landed;
    m_footsteps.back().speed = landed ? seen.fallSpeed : speed;
}

void CharacterReports::step(std::span<const CharacterMove> moves, const World& world, double stride) {
    m_footsteps.clear();
    m_inWater.clear();
    for (const CharacterMove& move : moves) {
        const uint32_t slot = move.character.slot();
        if (!world.characters().find(move.character)) continue;
        if (m_seen.size() <= slot) m_seen.resize(slot + 1);
        Seen& seen = m_seen[slot];
        WaterHandle water;
        world.waters().forEach([&](WaterHandle handle, const Water& each) {
            if (!water && each.contains(move.position)) water = handle;
        });
        if (seen.character != move.character) {
            seen = {move.character};
        } else {
            walk(move, seen, world, stride);
            if (water && !seen.inWater) {
                const Water& entered = world.waters().at(water);
                m_inWater.push_back({move.character,
                                     water,
                                     {move.position.x, entered.surface, move.position.z},
                                     glm::length(move.velocity - entered.flow)});
            }
        }
        seen.grounded = move.grounded, seen.inWater = bool(water), seen.fallSpeed = -move.velocity.y;
    }
}

}  // namespace rubble
