#include "render/scene/page_skips.h"

#include <algorithm>
#include <bit>

namespace rubble {
namespace {

/// A sector and the next one along each axis, as an octant sees them: 8x8x8 bricks in layers along z, from near to far;
/// bit x + 8 y of a layer.
using Window = std::array<uint64_t, 8>;

/// A set of the near sector's bricks, as an octant sees them: bit x + 4 (z & 1) + 8 y + 32 (z >> 1).
using NearSet = uint64_t;

/// The sides that a box may have. Each is at most twice the one before.
constexpr std::array<int, 6> kSides = {1, 2, 3, 4, 6, 8};
constexpr size_t kSizes = kSides.size() * kSides.size() * kSides.size();

constexpr std::array<uint8_t, 16> kReversed = {0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};

/// Row (y, z) of a set, mirrored where the octant goes down.
uint64_t rowOf(SectorBricks set, int y, int z, int octant) {
    const int fromY = octant & 2 ? 3 - y : y, fromZ = octant & 4 ? 3 - z : z;
    const uint64_t row = set >> (4 * fromY + 16 * fromZ) & 15;
    return octant & 1 ? kReversed[row] : row;
}

Window emptyBricks(const SectorSurroundings& occupied, int octant) {
    Window out;
    out.fill(~uint64_t(0));
    for (int i = 0; i < 8; ++i) {
        int index = 13;  // the sector in the middle
        for (int axis = 0, pitch = 1; axis < 3; ++axis, pitch *= 3)
            if (i >> axis & 1) index += octant >> axis & 1 ? -pitch : pitch;
        const SectorBricks set = occupied[size_t(index)];
        if (!set) continue;
        const int x = (i & 1) * 4, y = (i >> 1 & 1) * 4, z = (i >> 2) * 4;
        for (int k = 0; k < 4; ++k)
            for (int j = 0; j < 4; ++j) out[size_t(z + k)] ^= rowOf(set, j, k, octant) << (x + 8 * (y + j));
    }
    return out;
}

/// A box's size from its number: 1 for x, 6 for y and 36 for z, each times the index of its side.
std::array<int, 3> sizeOf(size_t number) {
    return {kSides[number % 6], kSides[number / 6 % 6], kSides[number / 36]};
}

/// The numbers of all sizes in order of preference.
std::array<size_t, kSizes> sizesInOrder() {
    std::array<size_t, kSizes> out{};
    for (size_t i = 0; i < out.size(); ++i) out[i] = i;
    std::stable_sort(out.begin(), out.end(), [&](size_t a, size_t b) {
        const auto [ax, ay, az] = sizeOf(a);
        const auto [bx, by, bz] = sizeOf(b);
        return ax * ay * az * (bx * by + by * bz + bz * bx) > bx * by * bz * (ax * ay + ay * az + az * ax);
    });
    return out;
}

/// Of layers the near sector's bricks, with those of the next layers behind: element k begins with layer k.
std::array<NearSet, 8> packNear(const Window& layers) {
    constexpr uint64_t kNear = 0x0f0f0f0f;
    std::array<NearSet, 11> pairs{};  // a layer and the next one
    for (size_t z = 0; z < 8; ++z) pairs[z] = (layers[z] & kNear) | (z < 7 ? (layers[z + 1] & kNear) << 4 : 0);
    std::array<NearSet, 8> out;
    for (size_t z = 0; z < 8; ++z) out[z] = pairs[z] | pairs[z + 2] << 32;
    return out;
}

/// For each size the bricks of the near sector that begin an empty box of it. Along an axis a longer box is two of the
/// side before, which may overlap. Nothing begins beyond the window.
std::array<NearSet, kSizes> listBoxes(const Window& empty) {
    std::array<NearSet, kSizes> boxes{};
    Window rows = empty;
    for (size_t i = 0; i < 6; ++i) {
        const int dx = i ? kSides[i] - kSides[i - 1] : 0;
        const uint64_t within = (0xffu >> dx) * 0x0101010101010101u;
        for (uint64_t& layer : rows) layer &= layer >> dx & within;
        Window planes = rows;
        for (size_t j = 0; j < 6; ++j) {
            const int dy = j ? kSides[j] - kSides[j - 1] : 0;
            for (uint64_t& layer : planes) layer &= layer >> (8 * dy);
            const std::array<NearSet, 8> near = packNear(planes);
            NearSet begins = near[0];
            for (size_t k = 0, z = 0; k < 6; ++k) {
                for (; z < size_t(kSides[k]); ++z) begins &= near[z];
                boxes[i + 6 * j + 36 * k] = begins;
            }
        }
    }
    return boxes;
}

void chooseBoxes(const SectorSurroundings& occupied, int octant, std::array<BrickSkips, 64>& skips) {
    static const std::array<size_t, kSizes> kInOrder = sizesInOrder();
    const std::array<NearSet, kSizes> boxes = listBoxes(emptyBricks(occupied, octant));
    const int mirror = 3 * ((octant & 1) + (octant & 2) * 2 + (octant & 4) * 4);
    NearSet rest = boxes[0];
    for (size_t i = 0; rest; ++i) {
        NearSet taken = boxes[kInOrder[i]] & rest;
        rest ^= taken;
        if (!taken) continue;
        const std::array<int, 3> size = sizeOf(kInOrder[i]);
        for (; taken; taken &= taken - 1) {
            const int bit = std::countr_zero(taken);
            const int x = bit & 3, y = bit >> 3 & 3, z = (bit >> 2 & 1) + (bit >> 5) * 2;
            BrickSkips& of = skips[size_t((x + 4 * y + 16 * z) ^ mirror)];
            for (size_t a = 0; a < 3; ++a) of[a] |= uint32_t(size[a]) << (4 * octant);
        }
    }
}

}  // namespace

void updatePageSkips(const SectorSurroundings& occupied, uint8_t octants, std::array<BrickSkips, 64>& skips) {
    uint32_t kept = 0;
    for (int octant = 0; octant < 8; ++octant) kept |= octants >> octant & 1 ? 0 : 15u << (4 * octant);
    for (BrickSkips& of : skips)
        for (uint32_t& sides : of) sides &= kept;
    for (int octant = 0; octant < 8; ++octant)
        if (octants >> octant & 1) chooseBoxes(occupied, octant, skips);
}

}  // namespace rubble
