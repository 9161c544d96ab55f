#include "tests/benchmark/mip_walks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct FloatRay {
    glm::vec3 origin, direction, inverse;
    float low = 0.0f, high;  ///< interval of t inside the grid
};

bool clip(const MipGrid& grid, const CellRay& ray, FloatRay& out) {
    out.origin = glm::vec3(ray.origin);
    out.direction = glm::vec3(ray.direction);
    out.high = float(ray.tMax);
    for (int a = 0; a < 3; ++a) {
        if (out.direction[a] == 0.0f) out.direction[a] = 1e-9f;
        out.inverse[a] = 1.0f / out.direction[a];
        const float t0 = -out.origin[a] * out.inverse[a],
                    t1 = (float(grid.size(0)[a]) - out.origin[a]) * out.inverse[a];
        out.low = std::max(out.low, std::min(t0, t1));
        out.high = std::min(out.high, std::max(t0, t1));
    }
    return out.low < out.high;
}

glm::ivec3 cellAt(const MipGrid& grid, const FloatRay& ray, float t) {
    glm::ivec3 cell;
    for (int a = 0; a < 3; ++a)
        cell[a] = std::clamp(int(std::floor(ray.origin[a] + ray.direction[a] * t)), 0, grid.size(0)[a] - 1);
    return cell;
}

}  // namespace

MipGrid::MipGrid(const VoxelGrid& grid) {
    m_size[0] = (grid.size() + 3) / 4 * 4;
    for (size_t level = 0; level < kLevels; ++level) {
        if (level > 0) m_size[level] = m_size[level - 1] / 2;
        m_cells[level].resize(size_t(m_size[level].x) * size_t(m_size[level].y) * size_t(m_size[level].z));
    }
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int i) {
            const glm::ivec3 voxel = position * kBrickSize + voxelInBrick(i);
            for (size_t level = 0; level < kLevels; ++level) {
                const glm::ivec3 cell = voxel >> int(level), size = m_size[level];
                m_cells[level][(size_t(cell.z) * size_t(size.y) + size_t(cell.y)) * size_t(size.x) + size_t(cell.x)] =
                    1;
            }
        });
    });
}

bool walkMips(const MipGrid& grid, const CellRay& ray) {
    FloatRay r;
    if (!clip(grid, ray, r)) return false;
    constexpr float kNudge = 1e-4f;
    int level = MipGrid::kLevels - 1;
    float t = r.low + kNudge;
    while (t < r.high) {
        const glm::ivec3 voxel = cellAt(grid, r, t), cell = voxel >> level;
        if (grid.occupied(level, cell)) {
            if (level == 0) return true;
            --level;
            continue;
        }
        float exit = kInfinity;
        for (int a = 0; a < 3; ++a) {
            const float plane = float((cell[a] + (r.direction[a] > 0.0f)) << level);
            exit = std::min(exit, (plane - r.origin[a]) * r.inverse[a]);
        }
        t = std::max(t, exit) + kNudge;
        const glm::ivec3 next = cellAt(grid, r, t);
        if (level + 1 < MipGrid::kLevels && next >> (level + 1) != voxel >> (level + 1)) ++level;
    }
    return false;
}

bool walkVoxels(const MipGrid& grid, const CellRay& ray) {
    FloatRay r;
    if (!clip(grid, ray, r)) return false;
    glm::ivec3 cell = cellAt(grid, r, r.low + 1e-4f);
    glm::vec3 next, delta;
    glm::ivec3 step;
    for (int a = 0; a < 3; ++a) {
        step[a] = r.direction[a] > 0.0f ? 1 : -1;
        delta[a] = std::fabs(r.inverse[a]);
        next[a] = (float(cell[a] + (r.direction[a] > 0.0f)) - r.origin[a]) * r.inverse[a];
    }
    for (;;) {
        if (grid.occupied(0, cell)) return true;
        const int a = next.x <= next.y ? (next.x <= next.z ? 0 : 2) : (next.y <= next.z ? 1 : 2);
        if (next[a] > r.high) return false;
        cell[a] += step[a];
        if (cell[a] < 0 || cell[a] >= grid.size(0)[a]) return false;
        next[a] += delta[a];
    }
}

}  // namespace rubble
