#pragma once
#include <algorithm>
#include <vector>

#include "runtime/core/random.h"
#include "runtime/destruction/components.h"
#include "runtime/voxel/material.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"
#include "tests/support/grids.h"

namespace rubble::test {

/// A grid as a plain array, for simple and slow reference algorithms.
struct PlainGrid {
    glm::ivec3 size;
    std::vector<uint8_t> cells;

    /// Copies the cells of a grid.
    explicit PlainGrid(const VoxelGrid& grid) : size(grid.size()), cells(size_t(size.x) * size.y * size.z) {
        grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
            forEachVoxel(content->occupancy,
                         [&](int i) { cells[index(brick * kBrickSize + voxelInBrick(i))] = content->at(i); });
        });
    }
    /// The index of a cell in `cells`.
    size_t index(glm::ivec3 c) const { return (size_t(c.z) * size.y + c.y) * size.x + c.x; }
    /// The cell of an index.
    glm::ivec3 cell(size_t i) const { return {int(i % size.x), int(i / size.x % size.y), int(i / size.x / size.y)}; }
    /// Whether a cell is inside.
    bool contains(glm::ivec3 c) const {
        return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < size.x && c.y < size.y && c.z < size.z;
    }
};

/// The components as sets of cell indices, each sorted, in the order of their first cell: a plain flood fill.
inline std::vector<std::vector<size_t>> floodFill(const PlainGrid& grid) {
    std::vector<std::vector<size_t>> out;
    std::vector<bool> seen(grid.cells.size());
    for (size_t start = 0; start < grid.cells.size(); ++start) {
        if (!grid.cells[start] || seen[start]) continue;
        std::vector<size_t> set = {start};
        seen[start] = true;
        for (size_t next = 0; next < set.size(); ++next)
            for (const glm::ivec3 step : kFaceOffsets) {
                const glm::ivec3 c = grid.cell(set[next]) + step;
                if (!grid.contains(c)) continue;
                const size_t i = grid.index(c);
                if (!grid.cells[i] || seen[i]) continue;
                seen[i] = true;
                set.push_back(i);
            }
        std::sort(set.begin(), set.end());
        out.push_back(std::move(set));
    }
    return out;
}

/// The cell indices of a component, sorted.
inline std::vector<size_t> cellsOf(const Component& component, const VoxelGrid& in, const PlainGrid& grid) {
    std::vector<size_t> out;
    forEachSubset(in, component, [&](glm::ivec3 brick, const Brick&, const BrickBits& voxels) {
        forEachVoxel(voxels, [&](int i) { out.push_back(grid.index(brick * kBrickSize + voxelInBrick(i))); });
    });
    std::sort(out.begin(), out.end());
    return out;
}

/// Materials 1 soft, 2 medium, 3 hard, 4 unbreakable, 5 unphysical.
inline MaterialTable fiveMaterials() {
    MaterialTable table;
    table.materials.resize(6);
    const Hardness classes[6] = {Hardness::Unphysical, Hardness::Soft,        Hardness::Medium,
                                 Hardness::Hard,       Hardness::Unbreakable, Hardness::Unphysical};
    for (size_t i = 0; i < 6; ++i) {
        table.materials[i].hardness = classes[i];
        table.materials[i].density = i == 5 || i == 0 ? 0 : uint32_t(300 + 700 * i);
    }
    return table;
}
/// Entry i is of material i of fiveMaterials().
inline Palette fiveEntries() {
    Palette palette{};
    for (size_t i = 1; i < 6; ++i)
        palette[i] = {.red = uint8_t(40 * i), .green = 100, .blue = 200, .material = uint8_t(i)};
    return palette;
}

}  // namespace rubble::test
