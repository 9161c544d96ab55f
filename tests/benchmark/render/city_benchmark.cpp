// The town again and again, as shapes that share their bricks: what primary visibility costs at equal pixels from 1e7 to 2e9 voxels.
#include <fmt/format.h>

#include <bit>
#include <map>

#include "tests/benchmark/render/gbuffer_rig.h"
#include "tests/benchmark/render/town_views.h"

namespace rubble::bench {
namespace {

constexpr double kTown = 64.0;  // metres

/// The shapes of one town, moved by whole towns, under handles of their own.
void addTown(FrameSnapshot& to, const FrameSnapshot& town, glm::ivec2 place, uint32_t firstSlot) {
    const glm::dvec3 offset(place.x * kTown, 0.0, place.y * kTown);
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
    for (const int side : {1, 4, 16}) {
        FrameSnapshot city;
        city.replacesAll = true;
        const uint32_t shapes = uint32_t(town.created.size());
        for (int i = 0; i < side * side; ++i) addTown(city, town, glm::ivec2(i % side, i / side) - side / 2, uint32_t(i) * shapes);
        GBufferRig rig(options.shaders, std::move(city));
        fmt::print("  {:.2g} voxels, {} shapes:", double(voxelsOf(town)) * side * side, rig.scene.bodies().shapes());
        size_t i = 0;
        for (const Place& place : placesInTown()) {
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

}  // namespace rubble::bench
