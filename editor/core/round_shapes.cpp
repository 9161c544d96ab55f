#include "editor/core/round_shapes.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "editor/core/cells.h"
#include "editor/core/palette.h"

namespace editor {
namespace {

/// The voxels that have a material, which alone are touched, all of one entry.
std::vector<rubble_voxel_run> touchedVoxels(const rubble::World& world, rubble_shape shape) {
    const std::vector<rubble_palette_entry> entries = paletteOf(world, shape);
    std::vector<rubble_voxel_run> runs;
    for (const uint8_t voxel : readCells(world, shape, gridOf(world, shape))) {
        const uint32_t index = voxel && entries[voxel].material ? 1 : 0;
        if (runs.empty() || runs.back().index != index) runs.push_back({0, index});
        ++runs.back().cells;
    }
    return runs;
}

}  // namespace

/// Physics says so in the log when it takes over the edit; the level's own world has none while it is edited.
bool isTouchedAs(const rubble::World& world, rubble_shape shape, uint32_t kind) {
    if (kind == RUBBLE_COLLISION_VOXELS || gridOf(world, shape).count() > kMaxCells) return true;
    bool isRefused = false;
    rubble_world_settings settings{.flags = RUBBLE_WORLD_NO_RENDERER};
    settings.user = &isRefused;
    settings.log = [](void* user, int32_t, const char* message) {
        if (std::string_view(message).starts_with("set_collision_shape:")) *static_cast<bool*>(user) = true;
    };
    rubble::World trial(settings);
    const std::vector<rubble_voxel_run> runs = touchedVoxels(world, shape);
    rubble_body_settings body{};
    body.flags = RUBBLE_BODY_STATIC;
    rubble_shape_settings copy{};
    copy.body = trial.create_body(body);
    copy.source = RUBBLE_SHAPE_RUNS;
    std::ranges::copy(world.get_shape_state(shape).size, copy.size);
    copy.runs = runs.data(), copy.count = runs.size();
    rubble_collision_shape touched{};
    touched.kind = kind;
    touched.shape = trial.create_shape(copy);
    trial.step();
    trial.set_collision_shape(touched);
    trial.step();
    return !isRefused;
}

}  // namespace editor
