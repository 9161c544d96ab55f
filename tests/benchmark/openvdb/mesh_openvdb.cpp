// Meshes of all shapes of the town: ours, and those of OpenVDB's volumeToMesh from the same voxels, on one thread and
// in alternation. Prints microseconds a brick, rectangles and the ratio of processor time.
#include <openvdb/openvdb.h>
#include <openvdb/tools/VolumeToMesh.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "runtime/voxel/greedy_mesh.h"
#include "runtime/world/world.h"
#include "samples/scenes/town.h"
#include "tests/support/cpu_time.h"

namespace {

constexpr int kRuns = 5;

/// The voxels of a shape as OpenVDB holds them: 1 where one is, 0 elsewhere.
openvdb::FloatGrid::Ptr gridOf(const rubble::VoxelGrid& voxels) {
    auto grid = openvdb::FloatGrid::create(0.0f);
    auto accessor = grid->getAccessor();
    voxels.forEachBrick([&](glm::ivec3 place, const rubble::BrickRef& brick) {
        rubble::forEachVoxel(brick->occupancy, [&](int i) {
            const glm::ivec3 cell = place * rubble::kBrickSize + rubble::voxelInBrick(i);
            accessor.setValue({cell.x, cell.y, cell.z}, 1.0f);
        });
    });
    return grid;
}

double median(std::vector<double> times) {
    std::nth_element(times.begin(), times.begin() + kRuns / 2, times.end());
    return times[kRuns / 2];
}

}  // namespace

int main() {
    openvdb::initialize();
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    rubble::World world;
    world.load(rubble::makeTown(1));
    std::vector<openvdb::FloatGrid::Ptr> grids;
    size_t bricks = 0, ours = 0, theirs = 0;
    world.shapes().forEach([&](rubble::ShapeHandle, const rubble::Shape& shape) {
        grids.push_back(gridOf(shape.grid));
        bricks += shape.grid.brickCount();
    });
    std::vector<double> greedyMs, openvdbMs;
    for (int run = 0; run < kRuns; ++run) {
        ours = theirs = 0;
        std::vector<rubble::FaceQuad> rectangles;
        greedyMs.push_back(rubble::cpuMs([&] {
            world.shapes().forEach([&](rubble::ShapeHandle, const rubble::Shape& shape) {
                const rubble::OpaqueEntries entries(*shape.palette);
                shape.grid.forEachBrick([&](glm::ivec3 brick, const rubble::BrickRef&) {
                    rectangles.clear();
                    rubble::meshBrick(shape.grid, brick, entries, rectangles);
                    ours += rectangles.size();
                });
            });
        }));
        std::vector<openvdb::Vec3s> points;
        std::vector<openvdb::Vec4I> quads;
        openvdbMs.push_back(rubble::cpuMs([&] {
            for (const auto& grid : grids) {
                points.clear(), quads.clear();
                openvdb::tools::volumeToMesh(*grid, points, quads, 0.5);
                theirs += quads.size();
            }
        }));
    }
    const double greedy = median(greedyMs), openvdb = median(openvdbMs);
    std::printf("bricks %zu\nours     %8.2f us a brick, %zu rectangles\nopenvdb  %8.2f us a brick, %zu quads\n", bricks,
                1e3 * greedy / double(bricks), ours, 1e3 * openvdb / double(bricks), theirs);
    std::printf("openvdb over ours %.1f\n", openvdb / greedy);
}
