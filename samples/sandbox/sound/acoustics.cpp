#include "samples/sandbox/sound/acoustics.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace sandbox::sound {
namespace {

constexpr size_t kRaysPerStep = 4;
constexpr double kFar = 40.0;     ///< metres: walls beyond give an echo, not a room
constexpr double kHead = 0.7;     ///< metres around the ear in which the player's own tools are
constexpr double kSurface = 0.3;  ///< metres before a sound that its own surface takes
constexpr double kAround = 0.5;   ///< metres beside it that sound bends around
constexpr size_t kRaysPerPlace = 3;

/// Directions that divide a sphere evenly: a spiral by the golden angle.
glm::dvec3 directionOf(size_t i, size_t count) {
    const double y = 1.0 - 2.0 * (double(i) + 0.5) / double(count), r = std::sqrt(1.0 - y * y);
    const double angle = double(i) * std::numbers::pi * (3.0 - std::sqrt(5.0));
    return {r * std::cos(angle), y, r * std::sin(angle)};
}

rubble_ray rayFrom(glm::dvec3 origin, glm::dvec3 direction, double distance) {
    rubble_ray ray = {};
    for (int i = 0; i < 3; ++i) ray.origin[i] = origin[i], ray.direction[i] = direction[i];
    ray.max_distance = distance;
    return ray;
}

}  // namespace

void Acoustics::listen(glm::dvec3 ear) {
    m_ear = ear;
    rubble_ray rays[kRaysPerStep];
    rubble_hit hits[kRaysPerStep] = {};
    size_t indices[kRaysPerStep];
    for (size_t i = 0; i < kRaysPerStep; ++i) {
        indices[i] = m_next = (m_next + 11) % kDirections;  // prime to 48: neighbours are far apart
        const glm::dvec3 direction = directionOf(m_next, kDirections);
        rays[i] = rayFrom(ear + kHead * direction, direction, kFar);
    }
    if (m_api.cast_rays(m_world, rays, kRaysPerStep, nullptr, hits) != RUBBLE_OK) return;
    for (size_t i = 0; i < kRaysPerStep; ++i) m_distances[indices[i]] = hits[i].hit ? hits[i].distance + kHead : 1e9;
    double sum = 0.0, walls = 0.0;
    for (const double distance : m_distances)
        if (distance < kFar) sum += distance, walls += 1.0;
    m_room.openness = 1.0 - walls / double(kDirections);
    m_room.freePath = walls > 0.0 ? 2.0 * sum / walls : kFar;  // from wall to wall, through the ear
}

void Acoustics::findOpenness(std::span<const glm::dvec3> places, std::vector<double>& openness) {
    openness.assign(places.size(), 1.0);
    m_rays.clear();
    for (const glm::dvec3& place : places) {
        const glm::dvec3 way = place - m_ear;
        const glm::dvec3 side = glm::normalize(glm::cross(way, glm::dvec3(0, 1, 0)) + glm::dvec3(1e-6, 0, 1e-6));
        for (const glm::dvec3& to :
             {place, place + kAround * side + glm::dvec3(0, kAround, 0), place - kAround * side}) {
            const double distance = glm::length(to - m_ear);
            const glm::dvec3 direction = distance > 1e-6 ? (to - m_ear) / distance : glm::dvec3(0, 1, 0);
            m_rays.push_back(rayFrom(m_ear + kHead * direction, direction, std::max(0.0, distance - kHead - kSurface)));
        }
    }
    m_hits.assign(m_rays.size(), rubble_hit{});
    if (m_rays.empty()) return;
    if (m_api.cast_rays(m_world, m_rays.data(), uint32_t(m_rays.size()), nullptr, m_hits.data()) != RUBBLE_OK) return;
    for (size_t i = 0; i < m_hits.size(); ++i)
        if (m_hits[i].hit) openness[i / kRaysPerPlace] -= 1.0 / double(kRaysPerPlace);
}

}  // namespace sandbox::sound
