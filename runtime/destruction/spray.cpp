#include "runtime/destruction/spray.h"

#include <algorithm>

#include "runtime/core/blue_noise.h"
#include "runtime/core/random.h"

namespace rubble {
namespace {

constexpr int kTile = 32;  ///< side of the blue-noise tile

}  // namespace

BrickBits ExposedBits::all() const {
    BrickBits out;
    for (size_t i = 0; i < 8; ++i) out[i] = x[i] | y[i] | z[i];
    return out;
}

int ExposedBits::axis(int voxel) const {
    return hasVoxel(z, voxel) ? 2 : hasVoxel(y, voxel) ? 1 : 0;
}

ExposedBits exposedBits(const VoxelGrid& grid, glm::ivec3 position, const Brick& brick) {
    const auto occupancy = [&](glm::ivec3 step) {
        const Brick* neighbour = grid.brickAt(position + step);
        return neighbour ? neighbour->occupancy : BrickBits{};
    };
    const BrickBits left = occupancy({-1, 0, 0}), right = occupancy({1, 0, 0}), below = occupancy({0, -1, 0}),
                    above = occupancy({0, 1, 0});
    const BrickBits back = occupancy({0, 0, -1}), front = occupancy({0, 0, 1});
    ExposedBits out;
    for (size_t z = 0; z < 8; ++z) {
        const uint64_t own = brick.occupancy[z];
        const uint64_t fromLeft = (own << 1 & ~kFirstColumn) | (left[z] >> 7 & kFirstColumn);
        const uint64_t fromRight = (own >> 1 & ~kLastColumn) | (right[z] & kFirstColumn) << 7;
        out.x[z] = own & ~(fromLeft & fromRight);
        out.y[z] = own & ~((own << 8 | below[z] >> 56) & (own >> 8 | above[z] << 56));
        out.z[z] = own & ~((z > 0 ? brick.occupancy[z - 1] : back[7]) & (z < 7 ? brick.occupancy[z + 1] : front[0]));
    }
    return out;
}

int surfaceNoise(glm::ivec3 cell, int axis, uint32_t seed) {
    static const std::vector<uint8_t> tile = makeBlueNoise(kTile);
    const uint32_t offset = hashCell(axis, 0, 0, seed);
    const int u = (axis == 0 ? cell.y : cell.x) + int(offset & 255);
    const int v = (axis == 2 ? cell.y : cell.z) + int(offset >> 8 & 255);
    return int(tile[size_t((v & (kTile - 1)) * kTile + (u & (kTile - 1)))]) * 255 / 256;
}

int rimFraction(const Brush& brush, glm::ivec3 cell) {
    if (brush.kind == BrushKind::Box || brush.radii[0] <= 0) return 0;
    using Wide = __int128;
    int64_t along = 0, length2 = 0, fromA2 = 0, fromB2 = 0;
    for (int i = 0; i < 3; ++i) {
        const int64_t point = int64_t(cell[i]) * kBrushUnit + kBrushUnit / 2, a = brush.a[size_t(i)];
        const int64_t b = brush.kind == BrushKind::Capsule ? brush.b[size_t(i)] : a;
        along += (point - a) * (b - a);
        length2 += (b - a) * (b - a);
        fromA2 += (point - a) * (point - a);
        fromB2 += (point - b) * (point - b);
    }
    const int64_t radius2 = brush.radii[0] * brush.radii[0];
    if (along <= 0) return int(std::min<int64_t>(255, fromA2 * 255 / radius2));
    if (along >= length2) return int(std::min<int64_t>(255, fromB2 * 255 / radius2));
    const Wide away =
        Wide(fromA2) * length2 - Wide(along) * along;  // the squared distance from the axis, times length2
    return int(std::min<Wide>(255, away / length2 * 255 / radius2));
}

}  // namespace rubble
