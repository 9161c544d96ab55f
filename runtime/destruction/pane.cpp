#include "runtime/destruction/pane.h"

#include <deque>
#include <map>
#include <tuple>

namespace rubble {
namespace {

constexpr uint64_t kLowX = 0x0101010101010101ull, kHighX = kLowX << 7;

BrickBits grownOnce(const BrickBits& bits, const BrickBits& within) {
    BrickBits out;
    for (size_t z = 0; z < 8; ++z) {
        const uint64_t w = bits[z];
        uint64_t grown = w | (w & ~kHighX) << 1 | (w & ~kLowX) >> 1 | w << 8 | w >> 8;
        if (z > 0) grown |= bits[z - 1];
        if (z < 7) grown |= bits[z + 1];
        out[z] = grown & within[z];
    }
    return out;
}

/// The cells of the neighbour across a face that these cells touch. face: as kFaceOffsets.
BrickBits across(const BrickBits& bits, size_t face) {
    BrickBits out{};
    for (size_t z = 0; z < 8; ++z) switch (face) {
            case 0:
                out[z] = (bits[z] & kLowX) << 7;
                break;
            case 1:
                out[z] = (bits[z] & kHighX) >> 7;
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
        BrickBits pane{};  ///< voxels of the kind
        size_t subset = 0;
    };
    std::vector<BrickSubset> out;
    std::map<std::tuple<int, int, int>, Seen> seen;
    std::deque<BrickSubset> open;  ///< cells to grow from
    uint64_t count = 0;
    const int start = voxelIndex(cell & 7);
    open.push_back({cell >> 3, {}});
    open.back().voxels[size_t(start >> 6)] = uint64_t(1) << (start & 63);
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
                if (isOfPane(brick->at(i))) known.pane[size_t(i >> 6)] |= uint64_t(1) << (i & 63);
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
