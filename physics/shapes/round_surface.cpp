#include "physics/shapes/round_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace rubble {
namespace {

/// Directions in which the cells must reach the surface: 16 around an axis, or 26 around a point.
class Directions {
public:
    explicit Directions(int axis) {
        if (axis < 0) {
            for (int i = 0; i < 27; ++i)
                if (const glm::vec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1); i != 13) add(d / std::sqrt(glm::dot(d, d)));
            return;
        }
        constexpr float kHalf = 0.7071067812f, kCos = 0.9238795325f, kSin = 0.3826834324f;  // of an eighth of pi
        constexpr std::array<std::array<float, 2>, 4> kQuarter{
            {{1.0f, 0.0f}, {kCos, kSin}, {kHalf, kHalf}, {kSin, kCos}}};
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const auto& [x, y] : kQuarter)
            for (const auto& [a, b] : {std::array{x, y}, {-y, x}, {-x, -y}, {y, -x}}) {
                glm::vec3 d(0.0f);
                d[u] = a, d[v] = b;
                add(d);
            }
    }
    /// Takes in a cell. center: its middle, from that of the surface.
    void include(const glm::vec3& center) {
        for (size_t i = 0; i < m_count; ++i)
            m_reach[i] = std::max(m_reach[i], glm::dot(m_direction[i], center) + m_corner[i]);
    }
    /// How far the cells reach in the direction in which they reach the least.
    float least() const { return *std::min_element(m_reach.begin(), m_reach.begin() + std::ptrdiff_t(m_count)); }

private:
    void add(const glm::vec3& direction) {
        m_corner[m_count] = 0.5f * (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
        m_direction[m_count++] = direction;
    }
    std::array<glm::vec3, 26> m_direction{};
    std::array<float, 26> m_reach{}, m_corner{};  ///< and from a cell's middle to its farthest corner
    size_t m_count = 0;
};

}  // namespace

std::optional<RoundSurface> fitRoundSurface(const VoxelGrid& grid, const CellBox& bounds, CollisionShape kind) {
    if (kind == CollisionShape::Voxels || bounds.empty()) return std::nullopt;
    RoundSurface fit;
    fit.axis = kind == CollisionShape::Sphere ? -1 : int(kind) - int(CollisionShape::CylinderX);
    fit.center = glm::vec3(bounds.low + bounds.high) * 0.5f;
    if (fit.axis >= 0) fit.halfLength = 0.5f * float(bounds.high[fit.axis] - bounds.low[fit.axis]);
    Directions directions(fit.axis);
    float farthest2 = 0.0f;
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        for (int i = 0; i < kBrickSize * kBrickSize * kBrickSize; ++i) {
            const glm::ivec3 cell(i % kBrickSize, i / kBrickSize % kBrickSize, i / (kBrickSize * kBrickSize));
            if (!brick->solid(voxelIndex(cell))) continue;
            const glm::vec3 middle = glm::vec3(position * kBrickSize + cell) + 0.5f - fit.center;
            glm::vec3 corner = glm::abs(middle) + 0.5f;
            if (fit.axis >= 0) corner[fit.axis] = 0.0f;
            directions.include(middle);
            if (const float distance2 = glm::dot(corner, corner); distance2 > farthest2) {
                farthest2 = distance2;
                fit.entry = grid.at(position * kBrickSize + cell);
            }
        }
    });
    fit.radius = std::sqrt(farthest2);
    if (directions.least() < fit.radius - kMaxRoundGap) return std::nullopt;
    return fit;
}

}  // namespace rubble
