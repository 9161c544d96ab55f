// What debris costs: nothing while it lies still, and what its number is worth while it breaks.
#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>

#include "physics/physics_world.h"
#include "runtime/core/profile.h"
#include "runtime/frame/snapshots.h"
#include "runtime/shadow/shadow_worker.h"
#include "runtime/world/world.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

PaletteRef brickPalette() {
    auto palette = std::make_shared<Palette>();
    for (size_t i = 1; i < 256; ++i) (*palette)[i].material = defaultMaterials().find("brick");
    return palette;
}

/// Filled with one entry; whole bricks are one shared brick.
VoxelGrid block(glm::ivec3 size) {
    VoxelGrid grid(size);
    BrickIndices full;
    full.fill(1);
    const BrickRef whole = makeBrick(full);
    const glm::ivec3 bricks = grid.sizeInBricks();
    for (int z = 0; z < bricks.z; ++z)
        for (int y = 0; y < bricks.y; ++y)
            for (int x = 0; x < bricks.x; ++x) {
                BrickIndices indices{};
                const glm::ivec3 low = glm::ivec3(x, y, z) * kBrickSize;
                const bool isWhole = low.x + 8 <= size.x && low.y + 8 <= size.y && low.z + 8 <= size.z;
                for (int i = 0; i < kBrickVoxels && !isWhole; ++i) indices[size_t(i)] = grid.contains(low + voxelInBrick(i)) ? 1 : 0;
                grid.setBrick({x, y, z}, isWhole ? whole : makeBrick(indices));
            }
    return grid;
}

LevelBody blockBody(glm::ivec3 size, glm::dvec3 corner, bool isStatic, const PaletteRef& palette) {
    LevelBody body{.name = "block", .pose = {corner}, .isStatic = isStatic};
    LevelShape shape{.name = "block", .grid = block(size), .palette = palette};
    body.shapes.push_back(std::move(shape));
    return body;
}

/// A frame loop without a renderer.
struct Loop {
    explicit Loop(const Level& level) {
        world.load(level);
        step();
    }
    void step(const Edits& edits = {}) {
        const FrameChanges changes = world.applyEdits(edits);
        {
            const ScopedTimer timer(physicsMs);
            physics.apply(changes, world);
            physics.step();
        }
        world.setPoses(physics.poses());
        queue.push(world.damageFrom(physics.impacts()));
        shadow.submit(changes, physics.poses(), world);
        snapshots.publish(changes, physics.poses(), world, shadow.takePatches());
    }
    World world;
    PhysicsWorld physics;
    ShadowWorker shadow{ShadowWorker::Mode::Inline};
    Snapshots snapshots;
    EditQueue queue;
    double physicsMs = 0.0;
};

/// 1e8 voxels of ground in blocks of 10 m; 10,000 pieces asleep on it.
Level sleepingLevel() {
    Level level;
    const PaletteRef palette = brickPalette();
    const LevelBody tile = blockBody({104, 96, 104}, {}, true, palette);
    for (int i = 0; i < 100; ++i) {
        level.bodies.push_back(tile);
        level.bodies.back().pose.position = glm::dvec3(i % 10, 0, i / 10) * 10.4;
    }
    const LevelBody piece = blockBody({4, 3, 4}, {}, false, palette);
    for (int i = 0; i < 10000; ++i) {
        level.bodies.push_back(piece);
        level.bodies.back().pose.position = {(i % 100) * 1.0 + 0.5, 9.6, (i / 100) * 1.0 + 0.5};
    }
    return level;
}

Loop& sleepingLoop() {
    static Loop loop(sleepingLevel());
    return loop;
}

void quietStep(benchmark::State& state) {
    Loop& loop = sleepingLoop();
    for (int i = 0; i < 10; ++i) loop.step();
    const size_t before = allocationCount();
    for (auto _ : state) loop.step();
    state.counters["allocations"] = double(allocationCount() - before);
    const Ledger ledger = loop.world.ledger();
    state.counters["voxels"] = double(ledger.standing + ledger.inPieces);
}
BENCHMARK(quietStep)->Name("destruction/debris/quietStep")->Unit(benchmark::kMicrosecond);

/// One piece is kept awake among the 10,000: the step costs that one.
void oneAwake(benchmark::State& state) {
    Loop& loop = sleepingLoop();
    BodyHandle last;
    loop.world.bodies().forEach([&](BodyHandle handle, const Body&) { last = handle; });
    int i = 0;
    loop.physicsMs = 0.0;
    for (auto _ : state) {
        const glm::dvec3 center = loop.world.bodies().at(last).pose.transformPoint({0.2, 0.15, 0.2});
        loop.step(i++ % 60 ? Edits{} : Edits{ImpulseEdit{last, center, {0, 250, 0}}});
    }
    state.counters["physics_us"] = 1e3 * loop.physicsMs / double(state.iterations());
    state.counters["awake"] = loop.physics.figures().awake;
}
BENCHMARK(oneAwake)->Name("destruction/debris/oneAwake")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace rubble
