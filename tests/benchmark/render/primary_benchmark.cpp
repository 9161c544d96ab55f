// Primary visibility: G-buffer and glass of the town, and our walk and G-buffer against Teardown's.
#include <fmt/format.h>

#include "tests/benchmark/render/gbuffer_rig.h"
#include "tests/benchmark/render/town_views.h"

namespace rubble::bench {
namespace {

/// A level that was just loaded.
FrameSnapshot snapshotOf(const Level& level) {
    World world;
    world.load(level);
    Snapshots snapshots;
    snapshots.publishWithoutShadow(world.applyEdits({}), {}, world);
    return std::move(*snapshots.take());
}

void benchTown(const Options& options) {
    FrameSnapshot town = snapshotOf(makeTown(1));
    benchCity(options, town);
    GBufferRig rig(options.shaders, std::move(town));
    fmt::print("\nthe town: milliseconds of processors' time\n");
    for (const TownView& place : townViews()) {
        rig.beginFrame(place.view(options.size, 0));
        const double gbuffer = medianMs(options.frames, [&] { rig.gbuffer.draw(rig.context()); });
        const double glass = medianMs(options.frames, [&] { rig.glass.draw(rig.context(), rig.gbuffer.tiles()); });
        fmt::print("  {:<10} gbuffer {:6.1f}   glass {:6.1f}   {} draws of bodies\n", place.name, gbuffer, glass,
                   rig.figures.bodyDraws);
    }
}

}  // namespace

int benchPrimary(const Options& options) {
    if (!benchWalk(options) || !benchBodies(options)) return 1;
    benchTown(options);
    return 0;
}

}  // namespace rubble::bench
