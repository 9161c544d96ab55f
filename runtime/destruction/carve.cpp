#include "runtime/destruction/carve.h"

namespace rubble {
namespace {

using EntryClasses = std::array<uint8_t, 256>;

EntryClasses entryClasses(const Palette& palette, const MaterialTable& materials, Tool tool) {
    EntryClasses classes{};
    for (size_t i = 0; i < 256; ++i) {
        const Material& material = materials[palette[i].material];
        classes[i] = uint8_t(breaksWith(material, tool) ? material.hardness : Hardness::Unbreakable);
    }
    return classes;
}

BrickBits bitsToRemove(const Brick& brick, const std::array<BrickBits, 3>& touched, const EntryClasses& classes) {
    BrickBits out{};
    if (!brick.indices) {
        const uint8_t hardness = classes[brick.uniform];
        if (hardness < 3)
            for (size_t z = 0; z < 8; ++z) out[z] = brick.occupancy[z] & touched[hardness][z];
        return out;
    }
    for (size_t z = 0; z < 8; ++z) {
        const uint64_t candidates = brick.occupancy[z] & (touched[0][z] | touched[1][z] | touched[2][z]);
        for (uint64_t word = candidates; word; word &= word - 1) {
            const int bit = std::countr_zero(word);
            const uint8_t hardness = classes[(*brick.indices)[z * 64 + size_t(bit)]];
            if (hardness < 3) out[z] |= touched[hardness][z] & uint64_t(1) << bit;
        }
    }
    return out;
}

}  // namespace

void carve(VoxelGrid& grid, const Brush& brush, const Palette& palette, const MaterialTable& materials, Carved& out, Tool tool) {
    const EntryClasses classes = entryClasses(palette, materials, tool);
    const Densities densities(palette, materials);
    const CellBox range = brushBricks(brush, grid.sizeInBricks());
    for (int z = range.low.z; z < range.high.z; ++z)
        for (int y = range.low.y; y < range.high.y; ++y)
            for (int x = range.low.x; x < range.high.x; ++x) {
                const glm::ivec3 position(x, y, z);
                const BrickRef brick = grid.shareBrick(position);
                if (!brick) continue;
                std::array<BrickBits, 3> touched;
                for (size_t c = 0; c < 3; ++c)
                    touched[c] = c && brush.radii[c] == brush.radii[c - 1] ? touched[c - 1] : brushBits(brush, position, brush.radii[c]);
                const BrickBits gone = bitsToRemove(*brick, touched, classes);
                if (gone != BrickBits{}) removeCells(grid, {position, gone}, densities, out);
            }
}

void removeCells(VoxelGrid& grid, const BrickShare& cells, const Densities& densities, Carved& out) {
    const BrickRef brick = grid.shareBrick(cells.brick);
    if (!brick) return;
    BrickBits gone, keep;
    for (size_t w = 0; w < 8; ++w) gone[w] = brick->occupancy[w] & cells.voxels[w], keep[w] = brick->occupancy[w] & ~cells.voxels[w];
    if (gone == BrickBits{}) return;
    forEachVoxel(gone, [&](int i) { ++out.removed[brick->at(i)], ++out.voxels; });
    out.moments += brickMoments(*brick, gone, cells.brick, densities);
    out.bricks.push_back(cells.brick);
    grid.setBrick(cells.brick, maskBrick(*brick, keep));
}

}  // namespace rubble
