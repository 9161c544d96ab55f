#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "runtime/frame/particles.h"

namespace rubble {
namespace {

constexpr double kCell = 1.5;          ///< metres: particles in one cell of this grid share a light
constexpr float kMinIntensity = 0.2f;  ///< radiant intensity that is worth a light
constexpr float kMaxReach = 25.0f;     ///< metres

}  // namespace

std::vector<SnapshotLight> Particles::lights() const {
    struct Glow {
        std::array<int64_t, 3> cell;
        size_t particle;
    };
    std::vector<Glow> glows;  // sorted: the same lights in the same order each time
    for (size_t i = 0; i < m_alive.size(); ++i) {
        if (m_alive[i].glow <= 0.0f) continue;
        const glm::dvec3 place = glm::floor(m_alive[i].position / kCell);
        glows.push_back({{int64_t(place.x), int64_t(place.y), int64_t(place.z)}, i});
    }
    std::sort(glows.begin(), glows.end(),
              [](const Glow& a, const Glow& b) { return std::tie(a.cell, a.particle) < std::tie(b.cell, b.particle); });
    std::vector<SnapshotLight> found;
    for (size_t first = 0, i = 0; first < glows.size(); first = i) {
        glm::dvec3 position(0.0);
        glm::vec3 color(0.0f);
        float sum = 0.0f;
        for (; i < glows.size() && glows[i].cell == glows[first].cell; ++i) {
            const Particle& p = m_alive[glows[i].particle];
            const float left = 1.0f - p.age / p.life, intensity = p.glow * left * left;
            position += p.position * double(intensity);
            color += p.kind == ParticleKind::Flame ? kFireColor * intensity : p.color * intensity;
            sum += intensity;
        }
        if (sum < kMinIntensity) continue;
        const float reach = std::min(3.0f + 2.0f * std::sqrt(sum), kMaxReach);
        found.push_back({LightKind::Sphere, position / double(sum), {0, -1, 0}, color, 0.25f, reach, 0.0f, 0.0f});
        found.back().fleeting = true;
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const SnapshotLight& a, const SnapshotLight& b) { return a.color.x > b.color.x; });
    if (found.size() > m_settings.maxLights) found.resize(m_settings.maxLights);
    return found;
}

}  // namespace rubble
