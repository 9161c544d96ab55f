#include "tests/physics/baseline/box_merge.h"

#include <algorithm>
#include <bit>
#include <tuple>

namespace rubble {
namespace {

/// The solid cells of a region, as bit x of row (y, z).
struct RegionBits {
    uint32_t rows[kRegionSize][kRegionSize] = {};  ///< [z][y]
};

/// The occupancy of a brick without its unphysical voxels.
std::array<uint64_t, 8> solidOccupancy(const Brick& brick, const SolidEntries& solid) {
    if (!brick.indices) return solid[brick.uniform] ? brick.occupancy : std::array<uint64_t, 8>{};
    std::array<uint64_t, 8> out = brick.occupancy;
    if ((solid | SolidEntries(1)).all()) return out;
    forEachVoxel(brick.occupancy, [&](int i) {
        if (!solid[(*brick.indices)[size_t(i)]]) clearVoxel(out, i);
    });
    return out;
}

bool readRegion(const VoxelGrid& grid, glm::ivec3 region, const SolidEntries& solid, RegionBits& bits) {
    bool any = false;
    for (int i = 0; i < 64; ++i) {
        const glm::ivec3 at(i & 3, i >> 2 & 3, i >> 4);
        const Brick* brick = grid.brickAt(region * 4 + at);
        if (!brick) continue;
        any = true;
        const std::array<uint64_t, 8> occupancy = solidOccupancy(*brick, solid);
        for (int z = 0; z < 8; ++z)
            for (int y = 0; y < 8; ++y)
                bits.rows[at.z * 8 + z][at.y * 8 + y] |= uint32_t(occupancy[size_t(z)] >> (8 * y) & 0xff) << (8 * at.x);
    }
    return any;
}

/// Removes from the bits the largest box that starts with the run at the row's lowest bit, and returns it.
CellBox takeBox(RegionBits& bits, int y, int z) {
    const uint32_t row = bits.rows[z][y];
    const int x = std::countr_zero(row);
    const int length = std::countr_one(row >> x);
    const uint32_t run = (length == 32 ? ~0u : (1u << length) - 1u) << x;
    const auto holds = [&](int rowY, int rowZ) { return (bits.rows[rowZ][rowY] & run) == run; };
    int endY = y + 1;
    while (endY < kRegionSize && holds(endY, z)) ++endY;
    const auto sliceHolds = [&](int sliceZ) {
        for (int i = y; i < endY; ++i)
            if (!holds(i, sliceZ)) return false;
        return true;
    };
    int endZ = z + 1;
    while (endZ < kRegionSize && sliceHolds(endZ)) ++endZ;
    for (int k = z; k < endZ; ++k)
        for (int i = y; i < endY; ++i) bits.rows[k][i] &= ~run;
    return {{x, y, z}, {x + length, endY, endZ}};
}

void joinAlong(std::vector<CellBox>& boxes, int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto key = [&](const CellBox& b) {
        return std::tuple(b.low[u], b.high[u], b.low[v], b.high[v], b.low[axis]);
    };
    std::sort(boxes.begin(), boxes.end(), [&](const CellBox& a, const CellBox& b) { return key(a) < key(b); });
    size_t kept = 0;
    for (const CellBox& box : boxes) {
        CellBox* last = kept ? &boxes[kept - 1] : nullptr;
        if (last && last->low[u] == box.low[u] && last->high[u] == box.high[u] && last->low[v] == box.low[v] &&
            last->high[v] == box.high[v] && last->high[axis] == box.low[axis])
            last->high[axis] = box.high[axis];
        else
            boxes[kept++] = box;
    }
    boxes.resize(kept);
}

}  // namespace

SolidEntries solidEntries(const Palette& palette, const MaterialTable& materials) {
    SolidEntries solid;
    for (size_t i = 1; i < 256; ++i) solid[i] = materials[palette[i].material].hardness != Hardness::Unphysical;
    return solid;
}

void mergeRegion(const VoxelGrid& grid, glm::ivec3 region, const SolidEntries& solid, std::vector<CellBox>& out) {
    RegionBits bits;
    if (!readRegion(grid, region, solid, bits)) return;
    const glm::ivec3 base = region * kRegionSize;
    for (int z = 0; z < kRegionSize; ++z)
        for (int y = 0; y < kRegionSize; ++y)
            while (bits.rows[z][y]) {
                const CellBox box = takeBox(bits, y, z);
                out.push_back({base + box.low, base + box.high});
            }
}

void joinBoxes(std::vector<CellBox>& boxes) {
    for (int axis = 0; axis < 3; ++axis) joinAlong(boxes, axis);
}

std::vector<CellBox> mergeGrid(const VoxelGrid& grid, const SolidEntries& solid) {
    std::vector<CellBox> boxes;
    const glm::ivec3 regions = (grid.size() + kRegionSize - 1) / kRegionSize;
    for (int z = 0; z < regions.z; ++z)
        for (int y = 0; y < regions.y; ++y)
            for (int x = 0; x < regions.x; ++x) mergeRegion(grid, {x, y, z}, solid, boxes);
    if (regions != glm::ivec3(1)) joinBoxes(boxes);
    return boxes;
}

VoxelGrid halveGrid(const VoxelGrid& grid, const SolidEntries& solid) {
    VoxelGrid half((grid.size() + 1) / 2);
    GridWriter writer(half);
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        for (int i = 0; i < 64; ++i) {
            const glm::ivec3 cell(i & 3, i >> 2 & 3, i >> 4);
            int count = 0;
            uint8_t index = 0;
            for (int child = 0; child < 8; ++child) {
                const uint8_t found = brick->at(cell * 2 + glm::ivec3(child & 1, child >> 1 & 1, child >> 2));
                if (!found || !solid[found]) continue;
                ++count;
                index = found;
            }
            if (count >= 4) writer.set(position * 4 + cell, index);
        }
    });
    return half;
}

}  // namespace rubble
