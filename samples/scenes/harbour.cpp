#include "samples/scenes/harbour.h"

#include <algorithm>

#include "runtime/core/random.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {

void addQuay(Level& level, const std::string& name, const CellBox& basin, double surface) {
    constexpr int kWall = 6;
    const ivec3 size = basin.high - basin.low + ivec3(0, 1, 0);
    Canvas c(size);
    const Swatch stone = c.addSurface(kConcreteDark), rim = c.addSurface(kKerb), mud = c.addSurface(kConcrete, 70),
                 fender = c.addSurface(kRubber), iron = c.addSurface(kDarkSteel), moss = c.addSurface(kMoss, 80);
    c.box({0, 0, 0}, {size.x, 1, size.z}, mud);
    c.fill({0, 1, 0}, size, [&](ivec3 cell) {
        const int edge = std::min({cell.x, size.x - 1 - cell.x, cell.z, size.z - 1 - cell.z});
        if (edge >= kWall) return uint8_t(0);
        if (cell.y >= size.y - 2) return PaletteBuilder::pick(rim, cell);
        const bool isWet = cell.y < size.y - 3 && hashCell(cell.x / 3, cell.y, cell.z / 3, 11) % 5 < 2;
        return PaletteBuilder::pick(isWet && edge == kWall - 1 ? moss : stone, cell);
    });
    // Fenders and bollards along the longer sides.
    const int along = size.x > size.z ? 0 : 2, across = 2 - along;
    const auto place = [&](int from, int to, int low, int high, int y0, int y1, Swatch swatch) {
        ivec3 corner(0, y0, 0), end(0, y1, 0);
        corner[along] = from, end[along] = to, corner[across] = low, end[across] = high;
        c.box(corner, end, swatch);
    };
    for (int at = 20; at < size[along] - 20; at += 30) {
        for (const int side : {kWall, size[across] - kWall - 2})
            place(at, at + 3, side, side + 2, 6, size.y - 2, fender);
        place(at + 12, at + 14, 2, 4, size.y - 1, size.y, iron);
    }
    addStatic(level, c.finish(name), basin.low);
    const double low = (basin.low.x + kWall) * kVoxel, high = (basin.high.x - kWall) * kVoxel,
                 near = (basin.low.z + kWall) * kVoxel, far = (basin.high.z - kWall) * kVoxel;
    level.waters.push_back({.name = name,
                            .outline = {{low, near}, {high, near}, {high, far}, {low, far}},
                            .surface = surface,
                            .depth = surface - (basin.low.y + 1) * kVoxel,
                            .color = {0.20f, 0.42f, 0.44f},
                            .clarity = 1.6f,
                            .waves = {.height = 0.02f, .length = 1.9f, .speed = 0.5f, .direction = 0.7f}});
}

void addPier(Level& level, const std::string& name, ivec3 cell, int depth) {
    const ivec3 size(100, depth + 5, 24);
    Canvas c(size);
    const Swatch board = c.addSurface(kFenceWood), pile = c.addSurface(kBark), beam = c.addSurface(kTimber);
    for (int x = 24; x < size.x; x += 24)
        for (const int z : {2, size.z - 5})
            c.box({x, 0, z}, {x + 3, x + 24 < size.x ? depth + 1 : depth + 5, z + 3}, pile);
    for (const int z : {2, size.z - 5}) c.box({0, depth, z}, {size.x, depth + 1, z + 3}, beam);
    c.fill({0, depth + 1, 0}, {size.x, depth + 2, size.z}, [&](ivec3 at) {
        return at.x % 4 == 3 ? uint8_t(0) : PaletteBuilder::pickFor(board, hashCell(at.x / 4, 0, 0, 23));
    });
    for (int z = 0; z < size.z; ++z) c.box({3, depth + 1, z}, {4, depth + 2, z + 1}, board);
    for (const int z : {4, size.z - 6})
        c.box({0, depth + 1, z}, {size.x, depth + 2, z + 2}, board);  // holds the planks together
    addStatic(level, c.finish(name), cell - ivec3(0, depth, 0));
}

}  // namespace rubble::scenes
