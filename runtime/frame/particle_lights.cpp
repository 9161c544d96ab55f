#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "runtime/frame/particles.h"

namespace rubble {
namespace {

constexpr double kCell = 1.5;          ///< metres: particles in one cell of this grid share a light
constexpr float kMinIntensity = 0.2f;  ///< radiant intensity that is worth a light
constexpr float kMaxReach = 25.0f;     ///< metres

}  // namespace

std::vector<SnapshotLight> Particles::lights() const {
    struct Cell {
        glm::dvec3 position{0.0};
        glm::vec3 color{0.0f};
        float intensity = 0.0f;
    };
    std::map<std::tuple<int64_t, int64_t, int64_t>, Cell> cells;  // sorted: the same lights in the same order each time
    for (const Particle& p : m_alive) {
        if (p.glow <= 0.0f) continue;
        const float left = 1.0f - p.age / p.life, intensity = p.glow * left * left;
        const glm::dvec3 place = glm::floor(p.position / kCell);
        Cell& cell = cells[{int64_t(place.x), int64_t(place.y), int64_t(place.z)}];
        cell.position += p.position * double(intensity);
        cell.color += p.kind == ParticleKind::Flame ? kFireColor * intensity : p.color * intensity;
        cell.intensity += intensity;
    }
    std::vector<SnapshotLight> found;
    for (const auto& [place, cell] : cells) {
        if (cell.intensity < kMinIntensity) continue;
        const float reach = std::min(3.0f + 2.0f * std::sqrt(cell.intensity), kMaxReach);
        found.push_back({LightKind::Sphere,
                         cell.position / double(cell.intensity),
                         {0, -1, 0},
                         cell.color,
                         0.25f,
                         reach,
                         0.0f,
                         0.0f});
    }
    for (SnapshotLight& light : found) light.fleeting = true;
    std::stable_sort(found.begin(), found.end(),
                     [](const SnapshotLight& a, const SnapshotLight& b) { return a.color.x > b.color.x; });
    if (found.size() > m_settings.maxLights) found.resize(m_settings.maxLights);
    return found;
}

}  // namespace rubble
