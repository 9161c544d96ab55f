#include "runtime/assets/vdb/fallback_palette.h"

#include <map>

#include "runtime/assets/vox_file.h"
#include "runtime/assets/vox_palette.h"

namespace rubble {
namespace {

PaletteEntry entryOf(uint8_t red, uint8_t green, uint8_t blue) {
    PaletteEntry entry;
    entry.red = red;
    entry.green = green;
    entry.blue = blue;
    entry.material = guessMaterial(entry);
    return entry;
}

template <class F>
void forEachCell(const VoxelGrid& grid, F&& f) {
    grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
        forEachVoxel(content->occupancy, [&](int i) { f(brick * kBrickSize + voxelInBrick(i)); });
    });
}

}  // namespace

PaletteRef grayFallbackPalette() {
    auto palette = std::make_shared<Palette>();
    (*palette)[1] = entryOf(170, 170, 170);
    return palette;
}

PaletteRef voxFallbackPalette(const VoxelGrid& grid) {
    auto palette = std::make_shared<Palette>();
    const auto colors = defaultVoxColors();
    forEachCell(grid, [&](glm::ivec3 cell) {
        const uint8_t index = grid.at(cell);
        if (!(*palette)[index].material)
            (*palette)[index] = entryOf(colors[index][0], colors[index][1], colors[index][2]);
    });
    return palette;
}

PaletteRef quantiseColors(VoxelGrid& grid, const std::function<glm::vec3(glm::ivec3)>& colorAt) {
    const auto packed = [&](glm::ivec3 cell) {
        const glm::vec3 color = colorAt(cell);
        return uint32_t(linearToSrgb(color.r)) << 16 | uint32_t(linearToSrgb(color.g)) << 8 | linearToSrgb(color.b);
    };
    std::map<uint32_t, uint8_t> entries;
    uint32_t mask = 0;
    for (uint32_t bits = 8; bits >= 2; --bits) {
        mask = (0xffu << (8 - bits) & 0xffu) * 0x10101u;
        entries.clear();
        forEachCell(grid, [&](glm::ivec3 cell) {
            if (entries.size() < 256) entries.try_emplace(packed(cell) & mask, uint8_t(0));
        });
        if (entries.size() < 256) break;
    }
    auto palette = std::make_shared<Palette>();
    uint8_t next = 1;
    for (auto& [color, index] : entries) {
        index = next++;
        const uint32_t middle = color | (~mask >> 1 & ~mask & 0x7f7f7fu);
        (*palette)[index] = entryOf(uint8_t(middle >> 16), uint8_t(middle >> 8), uint8_t(middle));
    }
    const VoxelGrid source = grid;
    GridWriter writer(grid);
    forEachCell(source, [&](glm::ivec3 cell) { writer.set(cell, entries.at(packed(cell) & mask)); });
    return palette;
}

}  // namespace rubble
