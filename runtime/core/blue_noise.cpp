#include "runtime/core/blue_noise.h"

#include <algorithm>
#include <cassert>

#include "runtime/core/random.h"

namespace rubble {
namespace {

constexpr double kGaussian = 0.87066;  // exp(-1 / (2 * 1.9^2)): the Gaussian of a square distance of 1

/// The points chosen so far and how crowded each index is: a sum of Gaussians on the torus.
struct PointPattern {
    int size, count;
    std::vector<bool> chosen;
    std::vector<int64_t> energy, kernel;

    explicit PointPattern(int side)
        : size(side), count(side * side), chosen(size_t(count)), energy(size_t(count)), kernel(size_t(count)) {
        std::vector<int64_t> gaussian(
            size_t(count / 2 + 1));  // by square distance; by multiplication, which rounds alike everywhere
        double value = 0x1p32;
        for (int64_t& each : gaussian) {
            each = int64_t(value);
            value *= kGaussian;
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
            for (int x = 0; x < size; ++x) energy[size_t(y * size + x)] += sign * row[(x - px) & (size - 1)];
        }
    }
    int tightestCluster() const { return extreme(true, -1); }
    int largestVoid() const { return extreme(false, 1); }

private:
    int extreme(bool isChosen, int64_t sign) const {
        int best = -1;
        for (int i = 0; i < count; ++i)
            if (chosen[size_t(i)] == isChosen && (best < 0 || sign * energy[size_t(i)] < sign * energy[size_t(best)]))
                best = i;
        return best;
    }
};

}  // namespace

std::vector<uint8_t> makeBlueNoise(int size) {
    assert(size >= 16 && (size & (size - 1)) == 0);
    PointPattern pattern(size);
    const int count = pattern.count;
    Random random(7);
    for (int i = 0; i < count / 10; ++i) {
        const int index = int(random.below(uint32_t(count)));
        if (!pattern.chosen[size_t(index)]) pattern.toggle(index);
    }
    for (int moved = 0; moved < count;
         ++moved) {  // spread the first points until the tightest is also the loneliest index
        const int from = pattern.tightestCluster();
        pattern.toggle(from);
        const int to = pattern.largestVoid();
        pattern.toggle(to);
        if (to == from) break;
    }
    std::vector<int> rank(size_t(count), 0);
    const PointPattern first = pattern;
    const int points = int(std::count(first.chosen.begin(), first.chosen.end(), true));
    for (int n = points - 1; n >= 0; --n) {
        const int index = pattern.tightestCluster();
        rank[size_t(index)] = n;
        pattern.toggle(index);
    }
    pattern = first;
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
