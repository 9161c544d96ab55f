#include "runtime/voxel/greedy_mesh.h"

#include <algorithm>
#include <bit>

#include "runtime/core/byte_bits.h"
#include "runtime/voxel/brick_entries.h"

namespace rubble {
namespace {

/// By side: the brick beyond it.
constexpr std::array<glm::ivec3, 6> kBeyond = {glm::ivec3(-1, 0, 0), glm::ivec3(1, 0, 0),  glm::ivec3(0, -1, 0),
                                               glm::ivec3(0, 1, 0),  glm::ivec3(0, 0, -1), glm::ivec3(0, 0, 1)};

/// The solid voxels of a brick, and those among them that hide what is behind them.
struct Cover {
    BrickBits solid{}, opaque{};
};

Cover coverOf(const Brick* brick, const OpaqueEntries& entries) {
    Cover cover;
    if (!brick) return cover;
    cover.solid = cover.opaque = brick->occupancy;
    if (entries.all) return cover;
    forEachEntry(*brick, brick->occupancy, [&](uint8_t entry, size_t z, uint64_t bits) {
        if (!entries.opaque[entry]) cover.opaque[z] &= ~bits;
    });
    return cover;
}

/// For each cell of a brick the bit of the cell beyond its side, which may be in the brick beyond.
BrickBits beyondOf(int side, const BrickBits& own, const BrickBits& beyond) {
    BrickBits out;
    for (size_t z = 0; z < 8; ++z) switch (side) {
            case 0:
                out[z] = (own[z] << 1 & ~kFirstColumn) | (beyond[z] & kLastColumn) >> 7;
                break;
            case 1:
                out[z] = (own[z] >> 1 & ~kLastColumn) | (beyond[z] & kFirstColumn) << 7;
                break;
            case 2:
                out[z] = own[z] << 8 | beyond[z] >> 56;
                break;
            case 3:
                out[z] = own[z] >> 8 | beyond[z] << 56;
                break;
            case 4:
                out[z] = z > 0 ? own[z - 1] : beyond[7];
                break;
            default:
                out[z] = z < 7 ? own[z + 1] : beyond[0];
        }
    return out;
}

/// The voxels whose faces at a side are seen.
BrickBits seenAt(int side, const Cover& own, const Cover& beyond, bool allOpaque) {
    BrickBits seen = beyondOf(side, own.opaque, beyond.opaque);
    for (size_t z = 0; z < 8; ++z) seen[z] = own.solid[z] & ~seen[z];
    if (allOpaque) return seen;
    const BrickBits solid = beyondOf(side, own.solid, beyond.solid);
    for (size_t z = 0; z < 8; ++z) seen[z] &= own.opaque[z] | ~solid[z];
    return seen;
}

/// How many bits, `stride` apart, are set without a gap from bit `first` on, at most `most`.
int runLength(uint64_t bits, int first, int stride, int most) {
    const uint64_t from = bits >> first;
    const uint64_t row = stride == 1 ? from & 0xff : gatherBits(from & kByteOnes);
    return std::min(std::countr_one(row), most);
}

/// The mask of such a run.
uint64_t runMask(int first, int stride, int length) {
    const uint64_t row = (uint64_t(1) << length) - 1;
    return (stride == 1 ? row : spreadBits(row)) << first;
}

/// Covers faces of one side by rectangles: each begins at the lowest voxel that is left, and is as long as it can be,
/// then as wide. Clears them.
template <class F>
void forEachRectangle(int side, BrickBits& faces, F&& f) {
    const int axis = side / 2;
    for (int z = 0; z < 8; ++z)
        while (const uint64_t bits = faces[size_t(z)]) {
            const int first = std::countr_zero(bits), x = first & 7, y = first >> 3;
            // Across x: along y, then z. Across y: along x, then z. Across z: along x, then y.
            const int stride = axis == 0 ? 8 : 1, length = runLength(bits, first, stride, axis == 0 ? 8 - y : 8 - x);
            uint64_t run = runMask(first, stride, length);
            int width = 0;
            if (axis == 2)
                for (; y + width < 8 && (faces[size_t(z)] & run) == run; run <<= 8, ++width) faces[size_t(z)] &= ~run;
            else
                for (; z + width < 8 && (faces[size_t(z + width)] & run) == run; ++width)
                    faces[size_t(z + width)] &= ~run;
            f(glm::ivec3(x, y, z), length, width);
        }
}

FaceQuad quadOf(int side, glm::ivec3 at, int length, int width) {
    const auto quad = [&](int layer, int u, int v, int across, int up) {
        return FaceQuad{uint8_t(side), uint8_t(layer), uint8_t(u), uint8_t(v), uint8_t(across), uint8_t(up), 0, 0};
    };
    if (side < 2) return quad(at.x, at.y, at.z, length, width);
    if (side < 4) return quad(at.y, at.z, at.x, width, length);
    return quad(at.z, at.x, at.y, length, width);
}

/// The voxels of a brick that have an entry and a paint.
BrickBits voxelsOf(const Brick& brick, uint8_t entry, uint8_t paint) {
    BrickBits out = kFullBrickBits;
    for (size_t z = 0; z < 8; ++z) {
        if (brick.indices) out[z] &= equalBits(brick.indices->data() + 64 * z, entry);
        if (brick.paint) out[z] &= equalBits(brick.paint->data() + 64 * z, paint);
    }
    return out;
}

}  // namespace

OpaqueEntries::OpaqueEntries(const Palette& palette) {
    for (size_t i = 0; i < 256; ++i) {
        opaque[i] = palette[i].opacity == 255;
        all &= opaque[i];
    }
}

void meshBrick(const VoxelGrid& grid, glm::ivec3 place, const OpaqueEntries& entries, std::vector<FaceQuad>& out) {
    const Brick* brick = grid.brickAt(place);
    if (!brick) return;
    const Cover own = coverOf(brick, entries);
    std::array<BrickBits, 6> seen;
    BrickBits left{};  // voxels with faces that have no rectangle yet
    for (int side = 0; side < 6; ++side) {
        const Cover beyond = coverOf(grid.brickAt(place + kBeyond[size_t(side)]), entries);
        seen[size_t(side)] = seenAt(side, own, beyond, entries.all);
        for (size_t z = 0; z < 8; ++z) left[z] |= seen[size_t(side)][z];
    }
    for (size_t layer = 0; layer < 8; ++layer)
        while (left[layer]) {
            const int voxel = int(64 * layer) + std::countr_zero(left[layer]);
            const uint8_t entry = brick->indices ? (*brick->indices)[size_t(voxel)] : brick->uniform;
            const uint8_t paint = brick->paintAt(voxel);
            const BrickBits alike = voxelsOf(*brick, entry, paint);
            for (size_t z = layer; z < 8; ++z) left[z] &= ~alike[z];
            for (int side = 0; side < 6; ++side) {
                BrickBits faces;
                for (size_t z = 0; z < 8; ++z) faces[z] = seen[size_t(side)][z] & alike[z];
                forEachRectangle(side, faces, [&](glm::ivec3 at, int length, int width) {
                    out.push_back(quadOf(side, at, length, width));
                    out.back().entry = entry;
                    out.back().paint = paint;
                });
            }
        }
}

std::array<glm::ivec3, 4> cornersOf(const FaceQuad& quad, glm::ivec3 brick) {
    const int axis = quad.side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<glm::ivec3, 4> out;
    for (size_t i = 0; i < 4; ++i) {
        const bool farU = i == 1 || i == 2, farV = i >= 2;
        glm::ivec3& corner = out[quad.side & 1 ? i : 3 - i];
        corner = brick * kBrickSize;
        corner[axis] += quad.layer + (quad.side & 1);
        corner[u] += quad.u + (farU ? quad.width : 0);
        corner[v] += quad.v + (farV ? quad.height : 0);
    }
    return out;
}

}  // namespace rubble
