// What pieces that fall off a level, or fly over it, cost the shadow volume: memory, and the bytes sent and texels
// written in the worst step. Work is counted, not timed, so that ten minutes of steps take seconds.
#include <cmath>
#include <utility>
#include <vector>

#include "render/scene/gpu_shadow_volume.h"
#include "runtime/core/random.h"
#include "runtime/shadow/shadow_worker.h"
#include "runtime/world/world.h"
#include "tests/render/gl_fixture.h"
#include "tests/runtime/shadow/received_volume.h"
#include "tests/support/allocation_count.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

constexpr double kStep = 1.0 / 60.0, kGravity = 9.81;

/// A plate of this side, 0.8 m thick, whose surface is at y = 0: four bodies, as a grid has a largest size.
std::vector<LevelBody> plates(double metres) {
    const int bricks = int(metres / 1.6);
    const BrickRef solid = solidGrid({8, 8, 8}).shareBrick({0, 0, 0});
    VoxelGrid grid({bricks * 8, 8, bricks * 8});
    for (int z = 0; z < bricks; ++z)
        for (int x = 0; x < bricks; ++x) grid.setBrick({x, 0, z}, solid);
    std::vector<LevelBody> out;
    for (int i = 0; i < 4; ++i)
        out.push_back(makeBody(grid, {{0.5 * metres * (i & 1), -0.8, 0.5 * metres * (i >> 1)}}, true));
    return out;
}

/// A body of 0.6 m and its flight.
struct Thrown {
    glm::dvec3 position, velocity;
};

/// The most of each over some steps.
struct Work {
    uint64_t sent = 0;         ///< bytes to the GPU
    uint64_t written = 0;      ///< texels of the directory
    uint64_t allocations = 0;  ///< calls of operator new
    void include(const Work& step) {
        sent = std::max(sent, step.sent);
        written = std::max(written, step.written);
        allocations = std::max(allocations, step.allocations);
    }
};

struct Cost {
    uint64_t gpu = 0, cpu = 0;  ///< most bytes held after a step
    Work worst, flying;         ///< of all steps, and of those after the first, which loads the level
    uint64_t gpuAtEnd = 0, cpuAtEnd = 0;
    size_t pieces = 0;  ///< at the end
};

/// Takes a step over into worker and GPU.
Work follow(ShadowWorker& worker, GpuShadowVolume& volume, const FrameChanges& changes, std::span<const BodyPose> moved,
            const World& world) {
    const uint64_t written = volume.directory().writtenTexels(), allocations = allocationCount();
    worker.submit(changes, moved, world);
    for (const ShadowPatches& publication : worker.takePatches())
        volume.apply(publication.patches, publication.replacesAll);
    const uint64_t sent = volume.upload();
    return {sent, volume.directory().writtenTexels() - written, allocationCount() - allocations};
}

/// Runs `steps` steps of pieces over a plate. They come to rest where they meet it; what is beside it falls on.
Cost run(double metres, std::vector<Thrown> thrown, int steps) {
    std::vector<LevelBody> bodies = plates(metres);
    for (const Thrown& each : thrown) bodies.push_back(makeBody(solidGrid({6, 6, 6}), {each.position}, false));
    World world = worldOf(std::move(bodies));
    std::vector<BodyPose> poses;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (!body.isStatic) poses.push_back({handle, body.pose, {}, {}, false});
    });
    const size_t heldBefore = allocatedBytes();
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    GpuShadowVolume volume;
    Cost cost;
    for (int step = 0; step < steps; ++step) {
        const FrameChanges changes = world.applyEdits({});
        std::vector<BodyPose> moved;
        for (size_t i = 0; i < poses.size(); ++i) {
            glm::dvec3& position = poses[i].pose.position;
            const bool isOver = position.x > -0.6 && position.x < metres && position.z > -0.6 && position.z < metres;
            if (!world.bodies().find(poses[i].body) || (isOver && position.y <= 0.0)) continue;
            thrown[i].velocity.y -= kGravity * kStep;
            position += thrown[i].velocity * kStep;
            if (isOver && position.y < 0.0) position.y = 0.0;
            moved.push_back(poses[i]);
        }
        world.setPoses(moved);
        const Work work = follow(worker, volume, changes, moved, world);
        cost.worst.include(work);
        if (step) cost.flying.include(work);
        cost.gpu = std::max(cost.gpu, cost.gpuAtEnd = volume.bytes());
        cost.cpu = std::max(cost.cpu, cost.cpuAtEnd = allocatedBytes() - heldBefore);
    }
    cost.pieces = world.bodies().size() - 4;
    return cost;
}

class ShadowVolumeBoundsTest : public GlTest {
protected:
    /// At most a tenth more than where nothing falls.
    static void expectNear(const Cost& cost, const Cost& calm) {
        const auto expectTenth = [](const char* what, uint64_t value, uint64_t of) {
            EXPECT_LE(value, of + of / 10) << what;
            RecordProperty(what, std::to_string(value) + " of " + std::to_string(of));
        };
        expectTenth("gpu_bytes", cost.gpu, calm.gpu);
        expectTenth("gpu_bytes_at_end", cost.gpuAtEnd, calm.gpuAtEnd);
        expectTenth("cpu_bytes", cost.cpu, calm.cpu);
        expectTenth("cpu_bytes_at_end", cost.cpuAtEnd, calm.cpuAtEnd);
        expectTenth("sent", cost.worst.sent, calm.worst.sent);
        expectTenth("written", cost.worst.written, calm.worst.written);
        expectTenth("allocations", cost.worst.allocations, calm.worst.allocations);
        EXPECT_LE(cost.flying.sent, uint64_t(2) << 20) << "no stall";
    }
};

TEST_F(ShadowVolumeBoundsTest, ACubeThatFallsOffALevelCostsNothingForTenMinutes) {
    const Cost calm = run(200.0, {{{100.0, 1.0, 100.0}, {1.0, 0.0, 0.0}}}, 60);
    const Cost cost = run(200.0, {{{199.0, 1.0, 100.0}, {3.0, 0.0, 0.0}}}, 10 * 60 * 60);
    expectNear(cost, calm);
    EXPECT_EQ(cost.pieces, 0u) << "it is dust";
}

TEST_F(ShadowVolumeBoundsTest, ACubeThrownAt60MetresPerSecondStallsNothing) {
    const Cost calm = run(512.0, {{{256.0, 1.0, 256.0}, {1.0, 0.0, 0.0}}}, 60);
    const Cost cost = run(512.0, {{{20.0, 1.0, 20.0}, {15.0, 60.0, 15.0}}}, 60 * 15);
    expectNear(cost, calm);
    EXPECT_EQ(cost.pieces, 1u) << "it comes down again within the bounds";
}

TEST_F(ShadowVolumeBoundsTest, TwoHundredPiecesOffAllEdgesCostATenthMore) {
    Random random(7);
    std::vector<Thrown> still, falling;
    for (int i = 0; i < 200; ++i) {
        const double along = 200.0 * double(random.unit()), out = 4.0 + 4.0 * double(random.unit());
        const bool isX = i & 1, isLow = i & 2;
        glm::dvec3 position(0.0, 1.0 + 3.0 * double(random.unit()), 0.0), velocity(0.0);
        position[isX ? 0 : 2] = isLow ? 0.4 : 199.0;
        position[isX ? 2 : 0] = along;
        velocity[isX ? 0 : 2] = isLow ? -out : out;
        falling.push_back({position, velocity});
        velocity *= -1.0;
        velocity.y = 12.0;  // as high as a sector, but over the level
        still.push_back({position, velocity});
    }
    const Cost calm = run(200.0, still, 120);
    const Cost cost = run(200.0, falling, 60 * 20);
    expectNear(cost, calm);
    EXPECT_EQ(cost.pieces, 0u) << "all are dust";
}

}  // namespace
}  // namespace rubble
