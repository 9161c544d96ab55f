#include "editor/ui/view/load_probe.h"

#include <algorithm>
#include <cmath>

#include "editor/core/cells.h"

namespace editor {
namespace {

constexpr int kSteps = 90;                            ///< of play with each load
constexpr int64_t kMaxTriedCells = int64_t(1) << 22;  ///< of the shape

/// Adds the cells that are left beside ones that went, and notes what went, so that none counts twice.
void compare(std::vector<uint8_t>& before, const std::vector<uint8_t>& after, const Cells& grid, int level,
             LoadProbe& probe) {
    const auto at = [&](glm::ivec3 c) { return (size_t(c.z) * grid.size.y + c.y) * grid.size.x + c.x; };
    glm::ivec3 cell;
    for (cell.z = 0; cell.z < grid.size.z; ++cell.z)
        for (cell.y = 0; cell.y < grid.size.y; ++cell.y)
            for (cell.x = 0; cell.x < grid.size.x; ++cell.x) {
                bool isEdge = false;
                for (int a = 0; a < 3 && after[at(cell)]; ++a)
                    for (const int step : {-1, 1}) {
                        glm::ivec3 next = cell;
                        next[a] += step;
                        isEdge = isEdge || (grid.contains(next) && before[at(next)] && !after[at(next)]);
                    }
                if (isEdge) probe.cells.push_back({cell, level});
            }
    for (size_t i = 0; i < before.size(); ++i)
        if (!after[i]) before[i] = 0;
}

}  // namespace

LoadProbe LoadProbe::of(rubble::World& world, rubble_shape shape) {
    LoadProbe probe;
    probe.shape = shape;
    const Cells grid = gridOf(world, shape);
    if (grid.count() > kMaxTriedCells) return probe;
    std::vector<uint8_t> before = readCells(world, shape, grid);
    const std::vector<uint8_t> game = world.save_game_data();
    rubble_world_settings plain{};
    plain.flags = RUBBLE_WORLD_NO_RENDERER;
    rubble::World copy(plain);
    for (int level = 0; level < kLevels; ++level) {
        copy.load_game_data(game.data(), game.size());
        rubble_settings settings = copy.get_settings();
        settings.flags |= RUBBLE_SETTING_STRESS;
        settings.strength_scale = std::max(settings.strength_scale * std::pow(0.5, level), 1e-6);
        copy.set_settings(settings);
        const rubble_shape own = copy.translate_handle(shape);
        for (int i = 0; i < kSteps; ++i) copy.step();
        std::vector<uint8_t> after(before.size());
        try {
            after = readCells(copy, own, grid);
        } catch (const rubble::Error&) {
        }  // the shape is gone as a whole
        const size_t found = probe.cells.size();
        compare(before, after, grid, level, probe);
        if (probe.weakest < 0 && probe.cells.size() > found) probe.weakest = level;
    }
    return probe;
}

}  // namespace editor
