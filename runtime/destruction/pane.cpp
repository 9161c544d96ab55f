#include "runtime/destruction/pane.h"

#include <deque>
#include <map>
#include <tuple>

namespace rubble {
namespace {

/// Adds the neighbours of all cells, in a brick.
BrickBits grownOnce(const BrickBits& bits, const BrickBits& within) {
    BrickBits out;
    for (size_t z = 0; z < 8; ++z) {
        const uint64_t w = bits[z];
        uint64_t grown = w | (w & ~kLastColumn) << 1 | (w & ~kFirstColumn) >> 1 | w << 8 | w >> 8;
        if (z > 0) grown |= bits[z - 1];
        if (z < 7) grown |= bits[z + 1];
        out[z] = grown & within[z];
    }
    return out;
}

/// The cells of the neighbouring brick beyond `face` that these cells touch. `face`: as in kFaceOffsets.
BrickBits across(const BrickBits& bits, size_t face) {
    BrickBits out{};
    for (size_t z = 0; z < 8; ++z) switch (face) {
            case 0:
                out[z] = (bits[z] & kFirstColumn) << 7;
                break;
            case 1:
                out[z] = (bits[z] & kLastColumn) >> 7;
                break;
            case 2:
                out[z] = bits[z] << 56;
                break;
            case 3:
                out[z] = bits[z] >> 56;
                break;
            default:
                break;
        }
    if (face == 4) out[7] = bits[0];
    if (face == 5) out[0] = bits[7];
    return out;
}

}  // namespace

std::vector<BrickSubset> findPane(const VoxelGrid& grid, glm::ivec3 cell, const std::function<bool(uint8_t)>& isOfPane,
                                  uint64_t limit) {
    struct Seen {
        BrickBits pane{};   ///< voxels of the kind
        size_t subset = 0;  ///< index in the result
    };
    std::vector<BrickSubset> out;
    std::map<std::tuple<int, int, int>, Seen> seen;
    std::deque<BrickSubset> open;  // cells to grow from
    uint64_t count = 0;
    open.push_back({brickOfCell(cell), {}});
    setVoxel(open.back().voxels, voxelIndex(cellInBrick(cell)));
    while (!open.empty() && count < limit) {
        const BrickSubset from = open.front();
        open.pop_front();
        const Brick* brick = grid.brickAt(from.brick);
        if (!brick) continue;
        const auto [place, isNew] = seen.try_emplace({from.brick.x, from.brick.y, from.brick.z});
        Seen& known = place->second;
        if (isNew) {
            known.subset = out.size();
            out.push_back({from.brick, {}});
            forEachVoxel(brick->occupancy, [&](int i) {
                if (isOfPane(brick->at(i))) setVoxel(known.pane, i);
            });
        }
        BrickBits& taken = out[known.subset].voxels;
        BrickBits grown = taken;
        for (size_t z = 0; z < 8; ++z) grown[z] |= from.voxels[z] & known.pane[z];
        if (grown == taken) continue;
        for (BrickBits next = grownOnce(grown, known.pane); next != grown; next = grownOnce(grown, known.pane))
            grown = next;
        for (size_t z = 0; z < 8; ++z) count += uint64_t(std::popcount(grown[z] & ~taken[z]));
        taken = grown;
        for (size_t face = 0; face < 6; ++face)
            if (const BrickBits seeds = across(grown, face); seeds != BrickBits{})
                open.push_back({from.brick + kFaceOffsets[face], seeds});
    }
    std::erase_if(out, [](const BrickSubset& subset) { return subset.voxels == BrickBits{}; });
    return out;
}

}  // namespace rubble
