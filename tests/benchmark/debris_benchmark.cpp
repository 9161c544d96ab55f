// Cost of debris: of 10,000 sleeping pieces, of one awake piece among them, and of breaking 10,000 pieces loose.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>

#include "physics/physics_world.h"
#include "runtime/core/profile.h"
#include "runtime/core/random.h"
#include "runtime/frame/snapshots.h"
#include "runtime/shadow/shadow_worker.h"
#include "runtime/world/impacts/impact_damage.h"
#include "runtime/world/world.h"
#include "tests/support/allocation_count.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

PaletteRef brickPalette() {
    auto palette = std::make_shared<Palette>();
    for (size_t i = 1; i < 256; ++i) (*palette)[i].material = defaultMaterials().find("brick");
    return palette;
}

LevelBody blockBody(glm::ivec3 size, glm::dvec3 corner, bool isStatic, const PaletteRef& palette) {
    LevelBody body{.name = "block", .pose = {corner}, .isStatic = isStatic};
    LevelShape shape{.name = "block", .grid = solidGridOfSharedBricks(size), .palette = palette};
    body.shapes.push_back(std::move(shape));
    return body;
}

/// A frame loop without a renderer.
struct Loop {
    explicit Loop(const Level& level) {
        world.load(level);
        physics.load(world);
        step();
    }
    FrameChanges step(const Edits& edits = {}) {
        FrameChanges changes;
        {
            const ScopedTimer timer(editsMs);
            changes = world.applyEdits(edits);
        }
        {
            const ScopedTimer timer(bodiesMs);
            physics.apply(changes, world);
        }
        {
            const ScopedTimer timer(physicsMs);
            physics.step();
        }
        world.setPoses(physics.poses());
        queue.push(impactDamage(world, physics.impacts()));
        shadow.submit(changes, physics.poses(), world);
        snapshots.publish(changes, physics.poses(), world, shadow.takePatches());
        return changes;
    }
    World world;
    PhysicsWorld physics;
    ShadowWorker shadow{ShadowWorker::Mode::Inline};
    Snapshots snapshots;
    EditQueue queue;
    double editsMs = 0.0, bodiesMs = 0.0, physicsMs = 0.0;
};

/// A ground of 1e8 voxels in blocks of 10 m, with 10,000 sleeping pieces on it.
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
    const VoxelAccounting accounting = voxelAccounting(loop.world);
    state.counters["voxels"] = double(accounting.standing + accounting.inPieces);
}
BENCHMARK(quietStep)->Name("destruction/debris/quietStep")->Unit(benchmark::kMicrosecond);

/// One piece of the 10,000 is kept awake: the step should cost only that one.
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
    state.counters["awake"] = loop.physics.stats().awake;
}
BENCHMARK(oneAwake)->Name("destruction/debris/oneAwake")->Unit(benchmark::kMicrosecond);

/// A cube of masonry with sides of 8 m.
Level cubeLevel() {
    Level level;
    level.bodies.push_back(blockBody({80, 80, 80}, {}, true, brickPalette()));
    return level;
}

/// One step with an explosion inside the cube and 16 cuts above it. Measures the step without the contact solver.
void blastAndCuts(benchmark::State& state) {
    World fresh;
    WorldSettings settings;
    settings.debris.fragmentsPerBreak = 4000;
    settings.debris.awakeBodies = 5000;
    fresh.setSettings(settings);
    fresh.load(cubeLevel());
    fresh.applyEdits({});
    Edits edits{ExplodeEdit{.position = {4.0, 4.0, 4.0}, .size = 4.0}};
    for (int i = 0; i < 16; ++i) {
        CarveEdit cut{.kind = BrushKind::Box, .position = {4.0, 7.5, 0.3 + 0.48 * i}, .halfSize = {4.1, 0.6, 0.05}};
        edits.push_back(cut);
    }
    size_t pieces = 0;
    bool balances = true;
    double bodiesMs = 0.0;
    for (auto _ : state) {
        World world = fresh;
        PhysicsWorld physics;
        physics.load(world);
        double editsMs = 0.0;
        FrameChanges changes;
        {
            const ScopedTimer timer(editsMs);
            changes = world.applyEdits(edits);
        }
        state.SetIterationTime(editsMs * 1e-3);
        pieces = changes.bodiesCreated.size();
        balances = balances && voxelAccounting(world).balances() && voxelAccounting(world).imported == 512000;
        const ScopedTimer timer(bodiesMs);
        physics.apply(changes, world);
    }
    state.counters["pieces"] = double(pieces);
    state.counters["accounting_exact"] = balances;
    state.counters["bodies_ms"] = bodiesMs / double(state.iterations());
}
BENCHMARK(blastAndCuts)
    ->Name("destruction/debris/blastAnd16Cuts")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->MinTime(0.3);

/// A wall of 60 x 40 m, broken in 600 places, two per step; at most 500 pieces may be awake.
void tenThousandPieces(benchmark::State& state) {
    Level level;
    const PaletteRef palette = brickPalette();
    level.bodies.push_back(blockBody({600, 400, 8}, {}, true, palette));
    level.bodies.push_back(blockBody({640, 10, 200}, {-2.0, -1.0, -10.0}, true, palette));
    for (auto _ : state) {
        Loop loop(level);
        WorldSettings settings = loop.world.settings();
        settings.debris.awakeBodies = 500;
        loop.world.setSettings(settings);
        Random random(3);
        size_t pieces = 0, maxAwake = 0, dusty = 0, stepsOver = 0;
        bool balances = true;
        double worstEditsMs = 0.0;
        for (int i = 0; i < 300; ++i) {
            const double x = random.unit(), y = random.unit();
            BreakEdit hit{.position = {(i % 30) * 2.0 + 0.5 + x, (i / 30) * 2.0 + 0.5 + y, 0.4}, .seed = uint32_t(i)};
            hit.radii.fill(1.0);
            BreakEdit above = hit;
            above.position.y += 20.0;
            const double before = loop.editsMs;
            const FrameChanges changes = loop.step({hit, above});
            worstEditsMs = std::max(worstEditsMs, loop.editsMs - before);
            pieces += changes.bodiesCreated.size();
            for (const DustCloud& cloud : changes.dust) dusty += cloud.count;
            maxAwake = std::max({maxAwake, loop.world.data().debris.awakeCount(), size_t(loop.physics.stats().awake)});
            stepsOver += loop.world.data().debris.awakeCount() > loop.world.settings().debris.awakeBodies;
            const VoxelAccounting accounting = voxelAccounting(loop.world);
            balances = balances && accounting.balances() && accounting.removed == dusty;
        }
        state.counters["pieces"] = double(pieces);
        state.counters["max_awake"] = double(maxAwake);
        state.counters["steps_over_budget"] = double(stepsOver);
        state.counters["accounting_exact"] = balances;
        state.counters["dust_share"] =
            double(dusty) / double(voxelAccounting(loop.world).imported - voxelAccounting(loop.world).standing);
        state.counters["edits_ms_worst"] = worstEditsMs;
        state.counters["edits_ms"] = loop.editsMs / 300.0;
        state.counters["bodies_ms"] = loop.bodiesMs / 300.0;
        state.counters["solver_ms"] = loop.physicsMs / 300.0;
    }
}
BENCHMARK(tenThousandPieces)->Name("destruction/debris/tenThousandPieces")->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace rubble
