// Rays through the world's occupancy: time of the exact walk and of two approximate walks that renderers use, and the
// errors of the approximate ones.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <glm/geometric.hpp>
#include <vector>

#include "runtime/core/random.h"
#include "runtime/voxel/ray_walk.h"

namespace rubble {
namespace {

constexpr glm::ivec3 kSize(384, 96, 384);
constexpr int kLevels = 3;
constexpr int kRays = 20000;
constexpr double kMaxDistance = 240.0;  // cells, 24 m
constexpr int kRuns = 9;

/// Occupancy at full, half and quarter resolution, a byte per cell; a coarse cell is solid if any of its cells is.
class MipOccupancy {
public:
    explicit MipOccupancy(const VoxelGrid& grid) {
        for (int level = 0; level < kLevels; ++level)
            m_levels[level].resize(size_t(sizeAt(level).x) * sizeAt(level).y * sizeAt(level).z);
        grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                for (int level = 0; level < kLevels; ++level)
                    m_levels[level][indexOf((position * kBrickSize + voxelInBrick(i)) >> level, level)] = 1;
            });
        });
    }
    bool solid(glm::dvec3 point, int level) const {
        return m_levels[level][indexOf(glm::ivec3(point) >> level, level)];
    }
    static bool inside(glm::dvec3 p) {
        return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < kSize.x && p.y < kSize.y && p.z < kSize.z;
    }

private:
    static glm::ivec3 sizeAt(int level) { return kSize >> level; }
    static size_t indexOf(glm::ivec3 cell, int level) {
        return (size_t(cell.z) * sizeAt(level).y + cell.y) * sizeAt(level).x + cell.x;
    }
    std::array<std::vector<uint8_t>, kLevels> m_levels;
};

/// Steps of fixed length: a level finer where a cell is solid, a level coarser where it is empty.
bool sparseHit(const MipOccupancy& world, const CellRay& ray) {
    int level = 0;
    for (double t = 0.5; t < ray.tMax;) {
        const glm::dvec3 point = ray.origin + ray.direction * t;
        if (!MipOccupancy::inside(point)) return false;
        if (!world.solid(point, level)) {
            t += double(1 << level);
            level = std::min(level + 1, kLevels - 1);
        } else if (level-- == 0) {
            return true;
        }
    }
    return false;
}

/// Five single and three double steps at full resolution, then eight at half and the rest at quarter resolution.
bool superSparseHit(const MipOccupancy& world, const CellRay& ray) {
    double t = 0.5;
    for (int step = 0; t < ray.tMax; ++step) {
        const glm::dvec3 point = ray.origin + ray.direction * t;
        if (!MipOccupancy::inside(point)) return false;
        const int level = step < 8 ? 0 : step < 16 ? 1 : 2;
        if (world.solid(point, level)) return true;
        t += step < 5 ? 1.0 : step < 16 ? 2.0 : 4.0;
    }
    return false;
}

/// Hollow houses with walls one cell thick on a floor, and thin poles between them.
VoxelGrid makeCity() {
    VoxelGrid grid(kSize);
    GridWriter writer(grid);
    Random random(11);
    for (int z = 0; z < kSize.z; ++z)
        for (int x = 0; x < kSize.x; ++x) writer.set({x, 0, z}, 1);
    for (int house = 0; house < 60; ++house) {
        const int x0 = random.between(0, 340), z0 = random.between(0, 340), width = random.between(12, 40),
                  depth = random.between(12, 40);
        const int height = random.between(10, 80);
        for (int y = 1; y <= height; ++y)
            for (int z = 0; z < depth; ++z)
                for (int x = 0; x < width; ++x)
                    if (x == 0 || z == 0 || x == width - 1 || z == depth - 1 || y % 27 == 0)
                        writer.set({x0 + x, y, z0 + z}, 1);
    }
    for (int pole = 0; pole < 300; ++pole) {
        const int x = random.between(0, kSize.x - 1), z = random.between(0, kSize.z - 1);
        for (int y = 1; y < 40; ++y) writer.set({x, y, z}, 1);
    }
    return grid;
}

/// Rays upward from free cells above random floors, as ambient light is gathered.
std::vector<CellRay> makeRays(const VoxelGrid& grid) {
    std::vector<CellRay> rays;
    Random random(12);
    while (int(rays.size()) < kRays) {
        const int x = random.between(1, kSize.x - 2), y = random.between(1, 60), z = random.between(1, kSize.z - 2);
        const double dx = random.unit() - 0.5, dy = random.unit(), dz = random.unit() - 0.5;
        if (grid.at({x, y, z}) || !grid.at({x, y - 1, z}) || dy == 0.0) continue;
        rays.push_back({glm::dvec3(x, y, z) + 0.5, glm::normalize(glm::dvec3(dx, dy, dz)), kMaxDistance});
    }
    return rays;
}

/// Nanoseconds per ray, median of the runs; `hits` receives the results.
template <class Hit>
double medianNs(const std::vector<CellRay>& rays, std::vector<uint8_t>& hits, Hit&& hit) {
    std::vector<double> runs;
    hits.resize(rays.size());
    for (int run = 0; run < kRuns; ++run) {
        const auto start = std::chrono::steady_clock::now();
        for (size_t i = 0; i < rays.size(); ++i) hits[i] = hit(rays[i]);
        runs.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count() /
                       double(rays.size()));
    }
    std::nth_element(runs.begin(), runs.begin() + kRuns / 2, runs.end());
    return runs[kRuns / 2];
}

/// Percentage of rays whose result is `said` but not in the exact walk.
double wrongPercent(const std::vector<uint8_t>& hits, const std::vector<uint8_t>& exact, bool said) {
    size_t wrong = 0;
    for (size_t i = 0; i < hits.size(); ++i) wrong += hits[i] == said && exact[i] != said;
    return 100.0 * double(wrong) / double(hits.size());
}

void worldRayRatios(benchmark::State& state) {
    const VoxelGrid grid = makeCity();
    const MipOccupancy world(grid);
    const std::vector<CellRay> rays = makeRays(grid);
    std::vector<uint8_t> exact, sparse, superSparse;
    for (auto _ : state) {
        const double exactNs = medianNs(rays, exact, [&](const CellRay& ray) { return walkRay(grid, ray).hit; });
        const double sparseNs = medianNs(rays, sparse, [&](const CellRay& ray) { return sparseHit(world, ray); });
        const double superNs =
            medianNs(rays, superSparse, [&](const CellRay& ray) { return superSparseHit(world, ray); });
        state.counters["exact_ns"] = exactNs;
        state.counters["sparse_over_exact"] = sparseNs / exactNs;
        state.counters["super_sparse_over_exact"] = superNs / exactNs;
    }
    state.counters["sparse_false_light_%"] = wrongPercent(sparse, exact, false);
    state.counters["sparse_false_shadow_%"] = wrongPercent(sparse, exact, true);
    state.counters["super_false_light_%"] = wrongPercent(superSparse, exact, false);
    state.counters["super_false_shadow_%"] = wrongPercent(superSparse, exact, true);
}
BENCHMARK(worldRayRatios)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rubble
