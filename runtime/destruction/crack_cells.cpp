#include "runtime/destruction/crack_cells.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "runtime/core/random.h"

namespace rubble {
namespace {

/// Adds a cell to the last subset, which is made that of the cell's brick.
void addCell(glm::ivec3 cell, std::vector<BrickSubset>& out) {
    const glm::ivec3 brick = brickOfCell(cell);
    if (out.empty() || out.back().brick != brick) {
        const auto same =
            std::find_if(out.begin(), out.end(), [&](const BrickSubset& subset) { return subset.brick == brick; });
        if (same != out.end())
            std::swap(*same, out.back());
        else
            out.push_back({brick, {}});
    }
    setVoxel(out.back().voxels, voxelIndex(cellInBrick(cell)));
}

}  // namespace

std::vector<BrickSubset> crackCells(const VoxelGrid& grid, std::span<const CellBox> anchors,
                                    const StrengthTable& entries, const Section& section) {
    std::vector<BrickSubset> out;
    glm::ivec3 step(0);
    step[section.axis] = 1;
    const auto isAnchored = [&](glm::ivec3 cell) {
        return std::any_of(anchors.begin(), anchors.end(), [&](const CellBox& box) { return box.contains(cell); });
    };
    for (uint64_t left = section.cells; left; left &= left - 1) {
        const glm::ivec3 below = section.cellBelow(std::countr_zero(left)), above = below + step;
        const EntryStrength &lower = entries[grid.at(below)], &upper = entries[grid.at(above)];
        const bool canLower = lower.canBreak && !isAnchored(below), canUpper = upper.canBreak && !isAnchored(above);
        if (!lower.isSolid || !upper.isSolid || (!canLower && !canUpper)) continue;
        const glm::ivec3 clump = below / 2;  // the cells of a clump of 2x2x2 choose alike
        const bool takesLower = canLower != canUpper             ? canLower
                                : lower.tensile != upper.tensile ? lower.tensile < upper.tensile
                                                                 : (hashCell(clump.x, clump.y, clump.z) & 1) != 0;
        addCell(takesLower ? below : above, out);
    }
    return out;
}

}  // namespace rubble
