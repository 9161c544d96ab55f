#include "runtime/core/blue_noise.h"

#include <algorithm>

#include "runtime/core/assertion.h"
#include "runtime/core/random.h"

// Void-and-cluster (R. Ulichney, "The void-and-cluster method for dither array generation", SPIE 1913, 1993).
//
// A dither array ranks the cells of a tile so that, for every n, the cells of the n lowest ranks are spread evenly.
// The density at a cell is a sum of Gaussians around all chosen cells, on the torus, because the tile repeats.
//   1. Choose random cells. Move the chosen cell of highest density (the tightest cluster) to the empty cell of lowest
//      density (the largest void), until the tightest cluster is also the largest void.
//   2. Remove the tightest cluster until none is left. The cell removed when n remain gets rank n.
//   3. Start again from the pattern of step 1 and fill the largest void until the tile is full. The n-th cell gets rank
//   n.
// Densities are integers, so the tile is the same on every machine.

namespace rubble {
namespace {

constexpr double kGaussian = 0.87066;  // exp(-1 / (2 * 1.9^2)): the Gaussian at distance 1

/// A set of chosen cells and the density at every cell.
struct PointPattern {
    int size, count;
    std::vector<bool> chosen;
    std::vector<int64_t> density, kernel;

    explicit PointPattern(int side)
        : size(side), count(side * side), chosen(size_t(count)), density(size_t(count)), kernel(size_t(count)) {
        std::vector<int64_t> gaussian(size_t(count / 2 + 1));  // by squared distance
        double value = 0x1p32;
        for (int64_t& each : gaussian) {
            each = int64_t(value);
            value *= kGaussian;  // a power by multiplication: exp() rounds differently on other machines
        }
        for (int i = 0; i < count; ++i) {
            const int x = std::min(i % size, size - i % size), y = std::min(i / size, size - i / size);
            kernel[size_t(i)] = gaussian[size_t(x * x + y * y)];
        }
    }
    void toggle(int index) {
        const int64_t sign = chosen[size_t(index)] ? -1 : 1;
        chosen[size_t(index)] = !chosen[size_t(index)];
        const int px = index % size, py = index / size;
        for (int y = 0; y < size; ++y) {
            const int64_t* row = kernel.data() + ((y - py) & (size - 1)) * size;
            for (int x = 0; x < size; ++x) density[size_t(y * size + x)] += sign * row[(x - px) & (size - 1)];
        }
    }
    int tightestCluster() const { return extreme(true, -1); }
    int largestVoid() const { return extreme(false, 1); }

private:
    int extreme(bool isChosen, int64_t sign) const {
        int best = -1;
        for (int i = 0; i < count; ++i)
            if (chosen[size_t(i)] == isChosen && (best < 0 || sign * density[size_t(i)] < sign * density[size_t(best)]))
                best = i;
        return best;
    }
};

/// Step 1.
PointPattern evenPattern(int size) {
    PointPattern pattern(size);
    Random random(7);
    for (int i = 0; i < pattern.count / 10; ++i) {
        const int index = int(random.below(uint32_t(pattern.count)));
        if (!pattern.chosen[size_t(index)]) pattern.toggle(index);
    }
    for (int i = 0; i < pattern.count; ++i) {
        const int from = pattern.tightestCluster();
        pattern.toggle(from);
        const int to = pattern.largestVoid();
        pattern.toggle(to);
        if (to == from) break;
    }
    return pattern;
}

}  // namespace

std::vector<uint8_t> makeBlueNoise(int size) {
    RUBBLE_ASSERT(size >= 16 && (size & (size - 1)) == 0);
    const PointPattern start = evenPattern(size);
    const int count = start.count, points = int(std::count(start.chosen.begin(), start.chosen.end(), true));
    std::vector<int> rank(size_t(count), 0);
    PointPattern pattern = start;
    for (int n = points - 1; n >= 0; --n) {
        const int index = pattern.tightestCluster();
        rank[size_t(index)] = n;
        pattern.toggle(index);
    }
    pattern = start;
    for (int n = points; n < count; ++n) {
        const int index = pattern.largestVoid();
        rank[size_t(index)] = n;
        pattern.toggle(index);
    }
    std::vector<uint8_t> tile(size_t(count), 0);
    for (int i = 0; i < count; ++i) tile[size_t(i)] = uint8_t(rank[size_t(i)] * 256 / count);
    return tile;
}

}  // namespace rubble
