// Meshes of the town's bricks by greedy rectangles, compared with a plain mesher that makes a rectangle of every face:
// both in one process and in alternation, both to the same rectangles.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "runtime/voxel/greedy_mesh.h"
#include "runtime/world/world.h"
#include "samples/scenes/town.h"
#include "tests/support/cpu_time.h"

namespace rubble {
namespace {

constexpr int kPadded = kBrickSize + 2;
constexpr std::array<int, 3> kStep = {1, kPadded, kPadded* kPadded};

/// Copies a brick and the layer of cells around it, so that the loop over voxels asks for no brick.
void expandPadded(const VoxelGrid& grid, glm::ivec3 brick, std::array<uint8_t, kPadded * kPadded * kPadded>& out) {
    out.fill(0);
    const auto copy = [&](glm::ivec3 offset) {
        const Brick* from = grid.brickAt(brick + offset);
        if (!from) return;
        glm::ivec3 low(0), high(kBrickSize);
        for (int a = 0; a < 3; ++a) {
            if (offset[a] > 0) high[a] = 1;
            if (offset[a] < 0) low[a] = kBrickSize - 1;
        }
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y)
                for (int x = low.x; x < high.x; ++x) {
                    const glm::ivec3 at = offset * kBrickSize + glm::ivec3(x, y, z) + 1;
                    out[size_t(at.x + at.y * kStep[1] + at.z * kStep[2])] = from->at(glm::ivec3(x, y, z));
                }
    };
    copy(glm::ivec3(0));
    for (int a = 0; a < 3; ++a)
        for (const int step : {-1, 1}) {
            glm::ivec3 offset(0);
            offset[a] = step;
            copy(offset);
        }
}

/// The plain mesher: every voxel, each of its sides, a rectangle for each face that is seen.
void meshFaces(const VoxelGrid& grid, glm::ivec3 brick, const OpaqueEntries& entries, std::vector<FaceQuad>& out) {
    std::array<uint8_t, kPadded * kPadded * kPadded> cells;
    expandPadded(grid, brick, cells);
    const Brick& own = *grid.brickAt(brick);
    for (int z = 0; z < kBrickSize; ++z)
        for (int y = 0; y < kBrickSize; ++y)
            for (int x = 0; x < kBrickSize; ++x) {
                const int at = (x + 1) + (y + 1) * kStep[1] + (z + 1) * kStep[2];
                const uint8_t entry = cells[size_t(at)];
                if (!entry) continue;
                const std::array<int, 3> place = {x, y, z};
                const uint8_t paint = own.paintAt(voxelIndex({x, y, z}));
                for (int side = 0; side < 6; ++side) {
                    const int axis = side / 2;
                    const uint8_t other = cells[size_t(at + (side & 1 ? kStep[size_t(axis)] : -kStep[size_t(axis)]))];
                    if (other && (entries.opaque[other] || !entries.opaque[entry])) continue;
                    out.push_back({uint8_t(side), uint8_t(place[size_t(axis)]), uint8_t(place[size_t((axis + 1) % 3)]),
                                   uint8_t(place[size_t((axis + 2) % 3)]), 1, 1, entry, paint});
                }
            }
}

struct Sums {
    double ms = 0.0;
    size_t bricks = 0, quads = 0;
};

template <class Mesh>
void meshWorld(const World& world, Mesh&& mesh, Sums& sums) {
    std::vector<FaceQuad> quads;
    const double start = threadMs();
    world.shapes().forEach([&](ShapeHandle, const Shape& shape) {
        const OpaqueEntries entries(*shape.palette);
        shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) {
            quads.clear();
            mesh(shape.grid, brick, entries, quads);
            ++sums.bricks;
            sums.quads += quads.size();
            benchmark::DoNotOptimize(quads.data());
        });
    });
    sums.ms += threadMs() - start;
}

template <class Mesh>
size_t areaOf(const World& world, Mesh&& mesh) {
    size_t area = 0;
    std::vector<FaceQuad> quads;
    world.shapes().forEach([&](ShapeHandle, const Shape& shape) {
        shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) {
            quads.clear();
            mesh(shape.grid, brick, OpaqueEntries(*shape.palette), quads);
            for (const FaceQuad& quad : quads) area += size_t(quad.width) * quad.height;
        });
    });
    return area;
}

void meshTown(benchmark::State& state) {
    World world;
    world.load(makeTown(1));
    if (areaOf(world, meshBrick) != areaOf(world, meshFaces)) throw std::runtime_error("the two areas differ");
    Sums greedy, plain;
    for (auto _ : state) {
        meshWorld(world, meshBrick, greedy);
        meshWorld(world, meshFaces, plain);
    }
    const double runs = double(state.iterations());
    state.counters["bricks"] = double(greedy.bricks) / runs;
    state.counters["greedy_us"] = 1e3 * greedy.ms / double(greedy.bricks);
    state.counters["plain_us"] = 1e3 * plain.ms / double(plain.bricks);
    state.counters["plain_over_greedy"] = plain.ms / greedy.ms;
    state.counters["greedy_quads"] = double(greedy.quads) / runs;
    state.counters["plain_quads"] = double(plain.quads) / runs;
}
BENCHMARK(meshTown)->Unit(benchmark::kMillisecond)->MinTime(2.0);

}  // namespace
}  // namespace rubble
