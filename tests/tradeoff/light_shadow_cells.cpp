#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/core/random.h"
#include "runtime/voxel/ray_walk.h"
#include "tests/golden/lit_scene.h"
#include "tests/reference/sampling.h"
#include "tests/reference/scene.h"
#include "tests/tradeoff/light.h"

namespace rubble::tradeoff {
namespace {

constexpr double kVoxel = 0.1;    // metres
constexpr double kFall = 10.0;    // m/s, of the cube whose shadow is late
constexpr glm::ivec3 kLow(-128);  // voxels: the street lies within 256^3 from here
constexpr uint32_t kCube = 5;     // slot of the cube in streetScene()

/// The shadow volume with one bit per `size`^3 voxels, set where any of them is solid.
VoxelGrid cellsOf(const FrameSnapshot& snapshot, int size) {
    VoxelGrid grid(glm::ivec3(256 / size));
    GridWriter writer(grid);
    for (const ShadowPatch& patch : snapshot.shadow) {
        if (!patch.content) continue;
        for (int i = 0; i < 16 * 16 * 16; ++i) {
            const glm::ivec3 cell(i & 15, i >> 4 & 15, i >> 8), word = cell >> 2, bit = cell & 3;
            if (!(patch.content->cells(word.x + word.y * 4 + word.z * 16) >> (bit.x + bit.y * 4 + bit.z * 16) & 1))
                continue;
            const glm::ivec3 at = patch.brick * 16 + cell - kLow;
            writer.set(at / size, 1);
        }
    }
    writer.flush();
    return grid;
}

/// A visible point, and a ray from it toward the sun or the sky.
struct Query {
    glm::dvec3 position, normal, direction;
    bool open;  ///< whether light passes, in the exact scene
};

std::vector<Query> queriesOf(const reference::Scene& scene, int count, uint64_t seed) {
    const View view = streetCamera(0).view({16, 9}, 0);
    Random random(seed);
    std::vector<Query> queries;
    while (int(queries.size()) < count) {
        const glm::dvec2 p = reference::unitSquare(random) * 2.0 - 1.0;
        const double tanY = std::tan(double(view.verticalFov) * 0.5);
        const reference::Surface s = scene.closest(
            {view.position, glm::normalize(view.rotation * glm::dvec3(p.x * tanY * 16 / 9, p.y * tanY, -1.0))});
        if (!s.hit || glm::length(s.position) > 12.0) continue;
        glm::dvec3 direction = reference::cosineDirection(s.normal, reference::unitSquare(random));
        const glm::dvec3 sun = glm::normalize(glm::dvec3(scene.environment().sunDirection));
        if (queries.size() % 2 && glm::dot(sun, s.normal) > 0.0) direction = sun;
        queries.push_back({s.position, s.normal, direction,
                           scene.transmittance({s.position + s.normal * 1e-6, direction, 24.0}).g > 0.0f});
    }
    return queries;
}

struct Errors {
    double shadow = 0.0, light = 0.0, ns = 0.0;  ///< shares of rays that are wrongly dark and wrongly lit; ns per ray
};

/// Traces the rays as surfaceOrigin() and shadowTrace() of shaders/lib/shadow_trace.glsl do, with cells of `size`
/// voxels.
Errors errorsOf(const VoxelGrid& cells, int size, const std::vector<Query>& queries) {
    Errors errors;
    const double cell = kVoxel * size;
    const double ms = cpuMs([&] {
        for (const Query& q : queries) {
            const glm::dvec3 along = glm::abs(q.normal);
            double leave = 0.52 * (along.x + along.y + along.z);
            if (std::max(along.x, std::max(along.y, along.z)) > 0.9999) {
                const double height = glm::dot(q.position, q.normal) / cell;
                leave = std::ceil(height - (size > 1 ? 0.001 : 0.499)) + 0.01 - height;
            }
            const glm::dvec3 origin = (q.position + q.normal * (leave * cell)) / cell - glm::dvec3(kLow) / double(size);
            const bool open = !walkRay(cells, {origin, q.direction, 24.0 / cell}).hit;
            errors.shadow += q.open && !open, errors.light += !q.open && open;
        }
    });
    errors.shadow /= double(queries.size()), errors.light /= double(queries.size());
    errors.ns = ms * 1e6 / double(queries.size());
    return errors;
}

}  // namespace

Table shadowCellTradeoff(const Options& options) {
    Table table{"T6",
                "voxels per bit of the shadow volume, and its delay in steps, against wrong rays",
                {"voxels per bit", "steps late", "false shadow %", "false light %", "ns per ray", "KB"},
                {}};
    table.note =
        "Sun and sky rays of 24 m from visible points of the street, against exact visibility (one cube is rotated; "
        "glass blocks nothing). Late: the cube falls at 10 m/s and its cells are still where it was; only rays near it "
        "count. KB: 64 bytes for each block of 8x8x8 bits that is not empty.";
    LitScene street = streetScene();
    const int count = options.full ? 400000 : 60000;
    const FrameSnapshot now = street.snapshot();
    const reference::Scene referenceScene(now);
    const std::vector<Query> queries = queriesOf(referenceScene, count, options.seed);
    Series wrong{"false shadow + light", {}};
    Errors finest, coarse;
    const auto add = [&](int size, int late, const Errors& e, const VoxelGrid& cells) {
        table.add({fmt::format("{0}x{0}x{0}", size), std::to_string(late), fmt::format("{:.3f}", e.shadow * 100),
                   fmt::format("{:.3f}", e.light * 100), fmt::format("{:.0f}", e.ns),
                   fmt::format("{:.0f}", double(cells.brickCount()) * 64.0 / 1024.0)});
    };
    for (const int size : {1, 2, 4, 8}) {
        const VoxelGrid cells = cellsOf(now, size);
        const Errors e = errorsOf(cells, size, queries);
        add(size, 0, e, cells);
        wrong.points.emplace_back(size, (e.shadow + e.light) * 100);
        if (size == 1) finest = e;
        if (size == 2) coarse = e;
    }
    const VoxelGrid cells = cellsOf(now, 1);
    for (const int late : {1, 2, 4, 8}) {
        LitScene later = streetScene();
        const Pose before = [&] {
            for (const SnapshotPose& pose : now.poses)
                if (pose.shape.slot() == kCube) return pose.current;
            return Pose{};
        }();
        later.move(ShapeHandle::make(1, 1, kCube),
                   {before.position + glm::dvec3(0, kFall * late / 60.0, 0), before.rotation});
        std::vector<Query> near;
        for (const Query& q : queriesOf(reference::Scene(later.snapshot()), count, options.seed))
            if (glm::distance(q.position, before.position) < 2.0) near.push_back(q);
        add(1, late, errorsOf(cells, 1, near), cells);
    }
    table.conclusion = fmt::format(
        "One bit per voxel is wrong for {:.2f} % of rays (at the rotated cube, whose cells are not its voxels); one "
        "bit per 2x2x2 voxels, as Teardown has it, for {:.1f} %.",
        (finest.shadow + finest.light) * 100, (coarse.shadow + coarse.light) * 100);
    writePlot(options, "T6", "Shadow cells: wrong rays by size of a cell", "voxels", "per cent", {wrong});
    return table;
}

}  // namespace rubble::tradeoff
