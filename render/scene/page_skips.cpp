#include "render/scene/page_skips.h"

namespace rubble {
namespace {

/// A sector and the next one along each axis, as an octant sees them: 8x8x8 bricks in layers along z, from near to far;
/// bit x + 8 y of a layer.
using Window = std::array<uint64_t, 8>;

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

/// From the bricks where an empty cube of some side begins, those where one of one more does: it is eight of the
/// former, which begin at the corners of a cube of two bricks (as in SkipDistances). Nothing begins beyond the window.
void growCubes(Window& begins) {
    constexpr uint64_t kNotLast = 0x7f7f7f7f7f7f7f7f;  // x
    for (uint64_t& layer : begins) {
        layer &= layer >> 1 & kNotLast;
        layer &= layer >> 8;
    }
    for (size_t z = 0; z < 7; ++z) begins[z] &= begins[z + 1];
    begins[7] = 0;
}

/// For four bits the same number in four places: bit i is 1 at place i.
constexpr std::array<std::array<uint32_t, 4>, 16> kSpread = [] {
    std::array<std::array<uint32_t, 4>, 16> out{};
    for (size_t bits = 0; bits < 16; ++bits)
        for (size_t i = 0; i < 4; ++i) out[bits][i] = uint32_t(bits >> i & 1);
    return out;
}();

/// Adds one to the side of every brick of the near sector where a cube begins.
void countCubes(const Window& begins, int octant, std::array<uint32_t, 64>& sides) {
    for (int z = 0; z < 4; ++z) {
        if (!begins[size_t(z)]) continue;
        for (int y = 0; y < 4; ++y) {
            const uint64_t row = begins[size_t(z)] >> (8 * y) & 15;
            const auto& ones = kSpread[octant & 1 ? kReversed[row] : row];
            uint32_t* to = &sides[size_t(4 * (octant & 2 ? 3 - y : y) + 16 * (octant & 4 ? 3 - z : z))];
            for (size_t x = 0; x < 4; ++x) to[x] += ones[x] << (4 * octant);
        }
    }
}

}  // namespace

std::array<uint32_t, 64> pageSkips(const SectorSurroundings& occupied) {
    std::array<uint32_t, 64> sides{};
    for (int octant = 0; octant < 8; ++octant) {
        Window begins = emptyBricks(occupied, octant);
        for (int side = 0; side < 8; ++side) {
            countCubes(begins, octant, sides);
            growCubes(begins);
        }
    }
    return sides;
}

}  // namespace rubble
