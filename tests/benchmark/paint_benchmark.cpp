// The two modes of paint, on the same wall with the same sprays; and a burning block of wood.
#include <benchmark/benchmark.h>

#include "runtime/core/random.h"
#include "runtime/destruction/paint.h"
#include "runtime/world/state/fires.h"
#include "runtime/world/world.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

constexpr glm::ivec3 kWall{256, 128, 16};

Palette someEntries(int count, const char* material) {
    Palette palette{};
    Random random(3);
    for (int i = 1; i <= count; ++i) {
        const uint8_t red = uint8_t(random.below(256)), green = uint8_t(random.below(256)),
                      blue = uint8_t(random.below(256));
        palette[size_t(i)] = {.red = red, .green = green, .blue = blue, .material = defaultMaterials().find(material)};
    }
    return palette;
}

/// A solid grid with a pattern of entries from 1 on.
VoxelGrid patternGrid(glm::ivec3 size, int entries) {
    return gridOf(size, [entries](glm::ivec3 c) { return uint8_t(1 + (c.x / 3 + c.y * 5 + c.z) % entries); });
}

/// 64 sprays of eight colours over a wall; counts painted voxels, merged palette entries and bytes.
void sprays(benchmark::State& state, bool byLayer) {
    const int entries = int(state.range(0));
    const VoxelGrid clean = patternGrid(kWall, entries);
    const PaletteRef palette = std::make_shared<const Palette>(someEntries(entries, "brick"));
    uint64_t voxels = 0, merges = 0;
    size_t bytes = 0;
    for (auto _ : state) {
        VoxelGrid grid = clean;
        PaletteRef entriesNow = palette;
        PaintColorsRef colors;
        voxels = merges = 0;
        for (uint32_t i = 0; i < 64; ++i) {
            const glm::dvec3 at(double(i * 37 % 256), double(i * 53 % 128), 16.0);
            const Brush brush = sphereBrush(at, {8, 8, 8});
            const Paint paint{.color = {uint8_t(32 * (i % 8)), 40, 200}, .strength = 100, .probability = 60, .seed = i};
            const PaintResult painted =
                byLayer ? paintLayer(grid, colors, brush, paint) : paintPalette(grid, entriesNow, brush, paint);
            if (painted.palette) entriesNow = painted.palette;
            if (painted.colors) colors = painted.colors;
            voxels += painted.voxels;
            merges += painted.merges;
        }
        bytes = grid.memoryBytes() + (colors ? sizeof(PaintColors) : 0) +
                (entriesNow != palette ? sizeof(Palette) : 0) - clean.memoryBytes();
    }
    state.counters["voxels"] = double(voxels);
    state.counters["merges"] = double(merges);
    state.counters["bytes"] = double(bytes);
}

void fires(benchmark::State& state) {
    Level level;
    LevelBody body{.name = "wood"};
    LevelShape shape{.name = "wood", .grid = patternGrid({160, 160, 24}, 3)};
    shape.palette = std::make_shared<const Palette>(someEntries(3, "wood"));
    body.shapes.push_back(shape);
    level.bodies.push_back(body);
    World world;
    world.load(level);
    WorldSettings settings;
    settings.fire.maxFires = uint32_t(state.range(0));
    settings.paint.mode = state.range(1) ? PaintMode::Layer : PaintMode::Blend;
    world.setSettings(settings);
    world.applyEdits({HeatEdit{.position = {8, 8, 1.2}, .radius = 12.0, .ignite = true}});
    size_t most = 0, steps = 0;
    for (auto _ : state) {
        world.applyEdits({});
        most = std::max(most, findFires(world).size());
        if (++steps == 240) {
            state.PauseTiming();
            world.load(level);
            world.applyEdits({HeatEdit{.position = {8, 8, 1.2}, .radius = 12.0, .ignite = true}});
            steps = 0;
            state.ResumeTiming();
        }
    }
    state.counters["fires"] = double(most);
}

[[maybe_unused]] const bool kRegistered = [] {
    for (const int entries : {28, 200}) {
        benchmark::RegisterBenchmark("destruction/paint/blend", [](benchmark::State& s) { sprays(s, false); })
            ->Arg(entries)
            ->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark("destruction/paint/layer", [](benchmark::State& s) { sprays(s, true); })
            ->Arg(entries)
            ->Unit(benchmark::kMillisecond);
    }
    benchmark::RegisterBenchmark("destruction/fire/step", fires)
        ->Args({128, 0})
        ->Args({512, 0})
        ->Args({512, 1})
        ->Unit(benchmark::kMicrosecond);
    return true;
}();

}  // namespace
}  // namespace rubble
