#include "runtime/shadow/shadow_volume.h"

#include <algorithm>
#include <bit>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace rubble {
namespace {

using Set = uint64_t;  ///< a set of a brick's words: bit x + 4 y + 16 z

/// The words in the lowest layer of each axis, and the distance in bits from one layer to the next.
constexpr std::array<Set, 3> kLowestLayer = {0x1111111111111111u, 0x000f000f000f000fu, 0x000000000000ffffu};
constexpr std::array<int, 3> kPitch = {1, 4, 16};

/// The words whose neighbour, one on along an axis in the octant's direction, is in the set. Beyond the brick all are.
Set neighborsAhead(Set set, int axis, int octant) {
    const size_t a = size_t(axis);
    return octant >> axis & 1
               ? (set << kPitch[a] & ~kLowestLayer[a]) | kLowestLayer[a]
               : (set >> kPitch[a] & ~(kLowestLayer[a] << (3 * kPitch[a]))) | kLowestLayer[a] << (3 * kPitch[a]);
}

/// The 63 sizes of boxes of more than one word, each as size - 1 in two bits for x, y, z, in order of preference: by
/// volume plus a bonus for the shortest side, because rays leave flat boxes soon.
constexpr std::array<uint8_t, 63> kSizes = [] {
    std::array<uint8_t, 63> out{};
    for (int i = 0; i < 63; ++i) out[size_t(i)] = uint8_t(i + 1);
    const auto score = [](int s) {
        const int x = (s & 3) + 1, y = (s >> 2 & 3) + 1, z = (s >> 4) + 1;
        const int least = x < y ? (x < z ? x : z) : (y < z ? y : z);
        return x * y * z + 6 * least;
    };
    for (size_t i = 1; i < out.size(); ++i)
        for (size_t k = i; k && score(out[k]) > score(out[k - 1]); --k) {
            const uint8_t swapped = out[k];
            out[k] = out[k - 1];
            out[k - 1] = swapped;
        }
    return out;
}();

/// For each size the words that begin an empty box of it. What lies beyond the brick counts as empty. A box is two
/// boxes: its first layer and the rest of it, one on.
void listBoxes(Set empty, int octant, std::array<Set, 64>& boxes) {
    boxes[0] = empty;
    for (int axis = 0; axis < 3; ++axis) {
        const size_t unit = size_t(1) << (2 * axis);
        for (size_t base = 0; base < unit; ++base)
            for (size_t size = 1; size < 4; ++size)
                boxes[base + size * unit] = boxes[base] & neighborsAhead(boxes[base + (size - 1) * unit], axis, octant);
    }
}

/// The sizes (less one) of all words as planes of bits: bit 0 and bit 1 for each axis.
using Planes = std::array<std::array<Set, 2>, 3>;

/// Shortens the boxes that leave the brick.
void endInBrick(Planes& planes, int octant) {
    for (size_t a = 0; a < 3; ++a) {
        const bool down = octant >> a & 1;
        const auto layer = [&](int stepsToEnd) {
            return kLowestLayer[a] << ((down ? stepsToEnd : 3 - stepsToEnd) * kPitch[a]);
        };
        auto& [low, high] = planes[a];
        low &= ~layer(0);
        high &= ~layer(0);
        low |= high & layer(1);
        high &= ~layer(1);
        low &= ~(high & layer(2));
    }
}

Planes chooseBoxes(Set empty, int octant) {
    std::array<Set, 64> boxes;
    listBoxes(empty, octant, boxes);
    Planes planes{};
    Set rest = empty;
    for (size_t i = 0; i < kSizes.size() && rest; ++i) {
        const uint8_t size = kSizes[i];
        const Set taken = boxes[size] & rest;
        if (!taken) continue;
        rest ^= taken;
        for (size_t bit = 0; bit < 6; ++bit)
            if (size >> bit & 1) planes[bit >> 1][bit & 1] |= taken;
    }
    endInBrick(planes, octant);
    return planes;
}

/// The largest empty cubes instead of boxes: rays skip nearly as far, for a tenth of the work.
Planes chooseCubes(Set empty, int octant) {
    std::array<Set, 3> cubes;  // of 2, 3 and 4 words
    Set begins = empty;
    for (Set& ofSize : cubes) {
        for (int axis = 0; axis < 3; ++axis)
            begins &= neighborsAhead(begins, axis, octant);  // cubes one smaller, at all eight corners
        ofSize = begins;
    }
    Planes planes;
    planes.fill({(cubes[0] & ~cubes[1]) | cubes[2], cubes[1]});
    endInBrick(planes, octant);
    return planes;
}

/// The planes of all octants in the order of a texel's bits: 16 for x, 16 for y, 16 for z, and 16 unused.
using PlaneRows = std::array<std::array<Set, 4>, 16>;

/// One step of a transposition: in the end, within each 16 bits, bit i of row k is bit k of row i (Warren, "Hacker's
/// Delight", 7-3).
template <size_t kHalf>
void swapHalves(PlaneRows& rows, Set mask) {
    for (size_t base = 0; base < 16; base += 2 * kHalf)
        for (size_t k = base; k < base + kHalf; ++k)
            for (size_t axis = 0; axis < 4; ++axis) {
                Set &a = rows[k][axis], &b = rows[k + kHalf][axis];
                const Set swap = (a >> kHalf ^ b) & mask;
                a ^= swap << kHalf;
                b ^= swap;
            }
}

/// After the transposition row k of each axis holds 16 bits of the words k, 16 + k, 32 + k and 48 + k.
void storeTexels(const PlaneRows& rows, ShadowWords& texels) {
#if defined(__SSE2__)
    for (size_t k = 0; k < 16; ++k) {
        const __m128i xy = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&rows[k][0]));
        const __m128i zNone = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&rows[k][2]));
        const __m128i xz = _mm_unpacklo_epi16(xy, zNone), yNone = _mm_unpackhi_epi16(xy, zNone);
        const __m128i low = _mm_unpacklo_epi16(xz, yNone), high = _mm_unpackhi_epi16(xz, yNone);
        _mm_storel_epi64(reinterpret_cast<__m128i*>(&texels[k]), low);
        _mm_storel_epi64(reinterpret_cast<__m128i*>(&texels[16 + k]), _mm_unpackhi_epi64(low, low));
        _mm_storel_epi64(reinterpret_cast<__m128i*>(&texels[32 + k]), high);
        _mm_storel_epi64(reinterpret_cast<__m128i*>(&texels[48 + k]), _mm_unpackhi_epi64(high, high));
    }
#else
    for (size_t k = 0; k < 16; ++k) {
        const auto& [x, y, z, none] = rows[k];
        for (size_t l = 0; l < 4; ++l)
            texels[16 * l + k] =
                (x >> (16 * l) & 0xffff) | (y >> (16 * l) & 0xffff) << 16 | (z >> (16 * l) & 0xffff) << 32;
    }
#endif
}

void makeTexels(Set empty, bool isTransient, ShadowWords& texels) {
    PlaneRows rows;
    for (size_t octant = 0; octant < 8; ++octant) {
        const Planes planes = isTransient ? chooseCubes(empty, int(octant)) : chooseBoxes(empty, int(octant));
        for (size_t bit = 0; bit < 2; ++bit)
            rows[2 * octant + bit] = {planes[0][bit], planes[1][bit], planes[2][bit], 0};
    }
    swapHalves<8>(rows, 0x00ff00ff00ff00ffu);
    swapHalves<4>(rows, 0x0f0f0f0f0f0f0f0fu);
    swapHalves<2>(rows, 0x3333333333333333u);
    swapHalves<1>(rows, 0x5555555555555555u);
    storeTexels(rows, texels);
}

Set occupiedWords(const ShadowWords& cells) {
    Set out = 0;
    for (int i = 0; i < 64; ++i) out |= Set(cells[size_t(i)] != 0) << i;
    return out;
}

}  // namespace

ShadowBrickRef makeShadowBrick(const ShadowWords& cells, bool isTransient, const std::shared_ptr<BlockPool>& pool) {
    const Set occupied = occupiedWords(cells);
    if (!occupied) return nullptr;
    auto brick =
        pool ? std::allocate_shared<ShadowBrick>(PoolAllocator<ShadowBrick>(pool)) : std::make_shared<ShadowBrick>();
    brick->occupied = occupied;
    if (~occupied) makeTexels(~occupied, isTransient, brick->texels);
    for (size_t i = 0; i < 64; ++i) brick->texels[i] = cells[i] ? cells[i] : brick->texels[i];
    return brick;
}

bool sameCells(const ShadowBrick& brick, const ShadowWords& cells) {
    for (int i = 0; i < 64; ++i)
        if (brick.cells(i) != cells[size_t(i)]) return false;
    return true;
}

ShadowChange changeBetween(const ShadowBrick* before, const ShadowBrick* after) {
    ShadowChange change{0, 0};
    for (int i = 0; i < 64; ++i) {
        const uint64_t cells = (before ? before->cells(i) : 0) ^ (after ? after->cells(i) : 0);
        change.words |= uint64_t(cells != 0) << i;
        change.cells += uint32_t(std::popcount(cells));
    }
    return change;
}

}  // namespace rubble
