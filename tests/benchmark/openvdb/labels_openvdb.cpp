// Connected components of whole volumes: ours from bricks, ours from bytes, OpenVDB's segmentActiveVoxels, and
// scipy.ndimage.label on the same bytes if python3 with SciPy is installed.
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#include "runtime/destruction/components.h"
#include "runtime/destruction/dense_labels.h"
#include "tests/benchmark/destruction_scenes.h"

namespace {

using namespace rubble;
using Sizes = std::vector<uint64_t>;

template <class Prepare, class F>
double bestMs(int times, Prepare&& prepare, F&& f) {
    double best = 1e30;
    for (int i = 0; i < times; ++i) {
        auto input = prepare();
        const auto start = std::chrono::steady_clock::now();
        f(input);
        best =
            std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

Sizes sorted(Sizes sizes) {
    std::sort(sizes.begin(), sizes.end());
    return sizes;
}

std::vector<uint8_t> bytesOf(const VoxelGrid& grid) {
    std::vector<uint8_t> cells(size_t(grid.size().x) * grid.size().y * grid.size().z);
    grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
        forEachVoxel(content->occupancy, [&](int i) {
            const glm::ivec3 c = brick * kBrickSize + voxelInBrick(i);
            cells[(size_t(c.z) * grid.size().y + c.y) * grid.size().x + c.x] = 1;
        });
    });
    return cells;
}

openvdb::BoolGrid::Ptr vdbOf(const VoxelGrid& grid) {
    auto out = openvdb::BoolGrid::create(false);
    grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
        const glm::ivec3 low = brick * kBrickSize;
        auto* leaf = out->tree().touchLeaf({low.x, low.y, low.z});
        forEachVoxel(content->occupancy, [&](int i) {
            const glm::ivec3 c = low + voxelInBrick(i);
            leaf->setValueOn({c.x, c.y, c.z}, true);
        });
    });
    return out;
}

double openVdbMs(const openvdb::BoolGrid& grid, size_t threads, Sizes& sizes) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    std::vector<openvdb::BoolGrid::Ptr> parts;
    const double ms = bestMs(
        3, [] { return 0; },
        [&](int) {
            parts.clear();
            openvdb::tools::segmentActiveVoxels(grid, parts);
        });
    sizes.clear();
    for (const auto& part : parts) sizes.push_back(part->activeVoxelCount());
    return ms;
}

/// OpenVDB makes a grid of about a third of a megabyte for each component: more components than this exhaust memory.
constexpr size_t kMaxGrids = 4000;

/// Milliseconds of SciPy on the bytes, timed by its own process; 0 if SciPy is not installed.
double scipyMs(const std::vector<uint8_t>& bytes, glm::ivec3 size, size_t& components) {
    const std::string folder = std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "/tmp",
                      file = folder + "/rubble_labels.raw";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    const std::string command = "/usr/bin/python3 " RUBBLE_LABELS_SCRIPT " " + file + " " + std::to_string(size.z) +
                                " " + std::to_string(size.y) + " " + std::to_string(size.x) + " 2>/dev/null";
    double ms = 0.0;
    if (FILE* pipe = popen(command.c_str(), "r")) {
        if (std::fscanf(pipe, "%lf %zu", &ms, &components) != 2) ms = 0.0;
        pclose(pipe);
    }
    std::remove(file.c_str());
    return ms;
}

bool compare(const char* name, const VoxelGrid& grid) {
    const std::vector<uint8_t> bytes = bytesOf(grid);
    Sizes fromBricks, fromBytes, one, many;
    const double bricksMs = bestMs(
        5, [&] { return bench::coldCopy(grid); }, [&](const VoxelGrid& cold) { fromBricks = componentSizes(cold); });
    std::vector<uint32_t> labels(bytes.size());
    const double denseMs = bestMs(
        5, [] { return 0; }, [&](int) { fromBytes = labelDense(grid.size(), bytes, labels); });
    const auto vdb = vdbOf(grid);
    const bool hasVdb = fromBricks.size() <= kMaxGrids;
    const double vdb1 = hasVdb ? openVdbMs(*vdb, 1, one) : 0.0,
                 vdbAll = hasVdb ? openVdbMs(*vdb, std::thread::hardware_concurrency(), many) : 0.0;
    size_t scipyCount = 0;
    const double scipy = scipyMs(bytes, grid.size(), scipyCount);
    const bool isEqual = sorted(fromBricks) == sorted(fromBytes) &&
                         (!hasVdb || (sorted(fromBricks) == sorted(one) && sorted(one) == sorted(many))) &&
                         (scipy == 0.0 || scipyCount == fromBricks.size());
    std::printf("%-14s %8zu %9.2f %9.2f", name, fromBricks.size(), bricksMs, denseMs);
    for (const double ms : {vdb1, vdbAll, scipy}) std::printf(ms > 0.0 ? " %9.1f" : "         -", ms);
    std::printf(" |");
    for (const double ms : {vdb1, vdbAll, scipy}) std::printf(ms > 0.0 ? " %7.1f" : "       -", ms / bricksMs);
    std::printf(" |");
    for (const double ms : {vdb1, scipy}) std::printf(ms > 0.0 ? " %7.1f" : "       -", ms / denseMs);
    std::printf("  %s\n", isEqual ? "equal" : "DIFFERENT");
    std::fflush(stdout);
    return isEqual;
}

}  // namespace

/// With an argument: only volumes whose names contain it.
int main(int argc, char** argv) {
    openvdb::initialize();
    std::printf(
        "destruction/label: milliseconds, best of 3 (OpenVDB, SciPy) and of 5 (ours); behind |: how many times faster "
        "we are. Ours: one thread.\n"
        "bricks: from the bits of cold bricks to components and their voxel counts. dense: from bytes to labels and "
        "counts.\n"
        "OpenVDB: from a BoolGrid to a grid for each component, with 1 thread and with %u; \"-\": too many grids. "
        "SciPy: from bytes to labels, one thread.\n",
        std::thread::hardware_concurrency());
    std::printf("%-14s %8s %9s %9s %9s %9s %9s | %7s %7s %7s | %7s %7s\n", "volume", "parts", "bricks", "dense",
                "vdb 1", "vdb all", "scipy", "b/vdb1", "b/vdbN", "b/scipy", "d/vdb1", "d/scipy");
    bool isEqual = true;
    for (const bench::Solid solid :
         {bench::Solid::Building, bench::Solid::Holed, bench::Solid::Cracked, bench::Solid::Halves,
          bench::Solid::Voronoi, bench::Solid::Noise20, bench::Solid::Noise32})
        for (const int size : {128, 256}) {
            if (argc > 1 && std::string(bench::kSolidNames[int(solid)]).find(argv[1]) == std::string::npos) continue;
            const std::string name = std::string(bench::kSolidNames[int(solid)]) + "/" + std::to_string(size);
            isEqual = compare(name.c_str(), bench::makeSolid(solid, size)) && isEqual;
        }
    return isEqual ? 0 : 1;
}
