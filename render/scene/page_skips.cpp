#include "render/scene/page_skips.h"

namespace rubble {
namespace {

/// A sector and the next one along each axis, as an octant sees them, from near to far: 4x4x4 bricks, bit x + 4 y +
/// 16 z.
using Window = uint64_t;

/// The place of a brick (x + 2 y + 4 z) among those of a window whose near corner is its own sector's.
int placeOf(int brick) {
    return (brick & 1) | (brick & 2) << 1 | (brick & 4) << 2;
}

Window emptyBricks(const SectorSurroundings& occupied, int octant) {
    Window out = ~Window(0);
    for (int i = 0; i < 8; ++i) {
        int index = 13;  // the sector in the middle
        for (int axis = 0, pitch = 1; axis < 3; ++axis, pitch *= 3)
            if (i >> axis & 1) index += octant >> axis & 1 ? -pitch : pitch;
        const SectorBricks set = occupied[size_t(index)];
        for (int brick = 0; brick < 8; ++brick)
            out &= ~(Window(set >> (brick ^ octant) & 1) << (2 * placeOf(i) + placeOf(brick)));
    }
    return out;
}

/// From the bricks where an empty cube of some side begins, those where one of one more does: it is eight of the
/// former, which begin at the corners of a cube of two bricks (as in SkipDistances). Nothing begins beyond the window.
Window growCubes(Window begins) {
    constexpr Window kNotLastX = 0x7777777777777777, kNotLastY = 0x0fff0fff0fff0fff;
    begins &= begins >> 1 & kNotLastX;
    begins &= begins >> 4 & kNotLastY;
    return begins & begins >> 16;
}

}  // namespace

std::array<uint32_t, 8> pageSkips(const SectorSurroundings& occupied) {
    std::array<uint32_t, 8> sides{};
    for (int octant = 0; octant < 8; ++octant)
        for (Window begins = emptyBricks(occupied, octant); begins; begins = growCubes(begins))
            for (int brick = 0; brick < 8; ++brick)
                sides[size_t(brick ^ octant)] += uint32_t(begins >> placeOf(brick) & 1) << (4 * octant);
    return sides;
}

}  // namespace rubble
