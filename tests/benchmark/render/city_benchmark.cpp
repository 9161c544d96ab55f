// Cities of copies of the town that share their bricks: the cost of a frame at equal pixels from 1e7 to 2e9 voxels.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>

#include "render/gl/offscreen.h"
#include "render/renderer.h"
#include "tests/benchmark/render/gbuffer_rig.h"
#include "tests/benchmark/render/town_views.h"
#include "tests/support/level_snapshot.h"

namespace rubble::bench {
namespace {

constexpr double kTownMetres = 64.0;
constexpr int kTownsPerSide[] = {1, 4, 16};
constexpr int kWarmUp = 20;  // frames, until the history of light is long

/// Adds a copy of the town's shapes, shadows and lights under new handles. place: in towns.
void addTown(FrameSnapshot& to, const FrameSnapshot& town, glm::ivec2 place, uint32_t firstSlot) {
    const glm::dvec3 offset(place.x * kTownMetres, 0.0, place.y * kTownMetres);
    std::map<uint32_t, ShapeHandle> renamed;
    for (SnapshotShape shape : town.created) {
        const ShapeHandle handle = ShapeHandle::make(1, 1, firstSlot + uint32_t(renamed.size()));
        renamed[shape.shape.slot()] = handle;
        shape.shape = handle;
        for (BrickChange& brick : shape.bricks) brick.shape = handle;
        to.created.push_back(std::move(shape));
    }
    for (SnapshotPose pose : town.poses) {
        pose.shape = renamed.at(pose.shape.slot());
        pose.previous.position += offset;
        pose.current.position += offset;
        to.poses.push_back(pose);
    }
    const glm::ivec3 bricks(glm::round(offset / (double(kShadowCell) * kShadowBrickCells)));
    for (const ShadowPatch& patch : town.shadow) to.shadow.push_back({patch.brick + bricks, patch.content});
    for (SnapshotLight light : town.lights) {
        light.light = LightHandle::make(1, 1, uint32_t(to.lights.size()));
        light.position += offset;
        to.lights.push_back(light);
    }
}

FrameSnapshot cityOf(const FrameSnapshot& town, int side) {
    FrameSnapshot city;
    city.replacesAll = city.shadowReplacesAll = city.lightsChanged = city.environmentChanged = true;
    city.environment = town.environment;
    city.materials = town.materials;
    const uint32_t shapes = uint32_t(town.created.size());
    for (int i = 0; i < side * side; ++i)
        addTown(city, town, glm::ivec2(i % side, i / side) - side / 2, uint32_t(i) * shapes);
    return city;
}

uint64_t voxelsOf(const FrameSnapshot& town) {
    uint64_t count = 0;
    for (const SnapshotShape& shape : town.created)
        for (const BrickChange& brick : shape.bricks)
            for (const uint64_t word : brick.content->occupancy) count += uint64_t(std::popcount(word));
    return count;
}

}  // namespace

void benchCity(const Options& options, const FrameSnapshot& town) {
    fmt::print("\nthe town in a city of towns, the same views: milliseconds of processors' time\n");
    std::vector<double> first;
    for (const int side : kTownsPerSide) {
        GBufferRig rig(options.shaders, cityOf(town, side));
        fmt::print("  {:.2g} voxels, {} shapes:", double(voxelsOf(town)) * side * side, rig.scene.bodies().shapes());
        size_t i = 0;
        for (const TownView& place : townViews()) {
            const View view = place.view(options.size, 0);
            rig.beginFrame(view);
            const double ms = medianMs(options.frames, [&] {
                rig.beginFrame(view);
                rig.gbuffer.draw(rig.context());
                rig.glass.draw(rig.context(), rig.gbuffer.tiles());
            });
            if (side == 1) first.push_back(ms);
            fmt::print("   {} {:.1f} ({:.2f}x)", place.name, ms, ms / first[i++]);
        }
        fmt::print("   {:.0f} MB on the GPU\n", double(rig.scene.bodies().bytes()) * 1e-6);
    }
}

/// Share of the pixels that show a surface: beyond one town there are fields, in a city more towns.
double surfaces(const Renderer& renderer) {
    const FloatImage depth = renderer.readTarget("depth").value();
    return double(std::count_if(depth.pixels.begin(), depth.pixels.end(),
                                [](glm::vec4 p) { return p.x < GBufferPass::kSkyDepth; })) /
           double(depth.pixels.size());
}

int benchCityFrames(const Options& options, GlContext& context) {
    const FrameSnapshot town = levelSnapshot(makeTown(1));
    const Offscreen target(options.size);
    std::vector<TownView> places = townViews();
    places.push_back({"from above", scenes::lookAt({32.0, 40.0, 46.0}, {32.0, 0.0, 34.0}),
                      0.70f});            // the same surfaces in each city
    std::map<std::string, double> first;  // milliseconds by view and pass
    for (const int side : kTownsPerSide) {
        RenderSettings settings = RenderSettings::preset(options.preset);
        settings.passTimes = true;
        auto renderer = Renderer::create(context.loader(), options.shaders, settings);
        if (!renderer) {
            fmt::print(stderr, "{}\n", renderer.error());
            return 1;
        }
        (*renderer)->apply(cityOf(town, side));
        fmt::print("\n{:.2g} voxels, {} lights: the whole frame, milliseconds {}\n",
                   double(voxelsOf(town)) * side * side, town.lights.size() * size_t(side) * size_t(side),
                   frameClockName());
        for (const TownView& place : places) {
            const View view = place.view(options.size, target.framebuffer());
            std::map<std::string, std::vector<double>> all;
            for (int i = -kWarmUp; i < options.frames; ++i) {
                const double before = frameClockMs();
                (*renderer)->draw(view, 1.0f);
                glFinish();
                if (i < 0) continue;
                all[" frame"].push_back(frameClockMs() - before);
                for (const auto& [pass, ms] : (*renderer)->stats().passMs) all[pass].push_back(ms);
            }
            for (const auto& [pass, ms] : all) {
                const double now = median(ms), then = first.emplace(place.name + pass, now).first->second;
                if (pass == " frame")
                    fmt::print("  {:<10}{:8.1f}  {:.2f}x, {:.0f} % of the pixels are surfaces;", place.name, now,
                               now / then, 100.0 * surfaces(**renderer));
                else if (std::abs(now - then) > 0.02 * first.at(place.name + std::string(" frame")))
                    fmt::print("  {} {:.1f} -> {:.1f} ms", pass, then, now);
            }
            fmt::print("\n");
        }
    }
    return 0;
}

}  // namespace rubble::bench
