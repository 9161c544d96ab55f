#include "runtime/core/blue_noise.h"

#include <algorithm>
#include <cassert>

#include "runtime/core/random.h"

namespace rubble {
namespace {

constexpr double kGaussian = 0.87066;  // exp(-1 / (2 * 1.9^2)): the Gaussian of a square distance of 1

/// The points chosen so far and how crowded each place is: a sum of Gaussians on the torus.
struct Crowd {
    int size, count;
    std::vector<bool> chosen;
    std::vector<int64_t> energy, kernel;

    explicit Crowd(int side) : size(side), count(side * side), chosen(size_t(count)), energy(size_t(count)), kernel(size_t(count)) {
        std::vector<int64_t> gaussian(size_t(count / 2 + 1));  // by square distance; by multiplication, which rounds alike everywhere
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
    void flip(int place) {
        const int64_t sign = chosen[size_t(place)] ? -1 : 1;
        chosen[size_t(place)] = !chosen[size_t(place)];
        const int px = place % size, py = place / size;
        for (int y = 0; y < size; ++y) {
            const int64_t* row = kernel.data() + ((y - py) & (size - 1)) * size;
            for (int x = 0; x < size; ++x) energy[size_t(y * size + x)] += sign * row[(x - px) & (size - 1)];
        }
    }
    int tightestCluster() const { return extreme(true, -1); }
    int largestVoid() const { return extreme(false, 1); }

private:
    int extreme(bool among, int64_t sign) const {
        int best = -1;
        for (int i = 0; i < count; ++i)
            if (chosen[size_t(i)] == among && (best < 0 || sign * energy[size_t(i)] < sign * energy[size_t(best)])) best = i;
        return best;
    }
};

}  // namespace

std::vector<uint8_t> makeBlueNoise(int size) {
    assert(size >= 16 && (size & (size - 1)) == 0);
    Crowd crowd(size);
    const int count = crowd.count;
    Random random(7);
    for (int i = 0; i < count / 10; ++i) {
        const int place = int(random.below(uint32_t(count)));
        if (!crowd.chosen[size_t(place)]) crowd.flip(place);
    }
    for (int moved = 0; moved < count; ++moved) {  // spread the first points until the tightest is also the loneliest place
        const int from = crowd.tightestCluster();
        crowd.flip(from);
        const int to = crowd.largestVoid();
        crowd.flip(to);
        if (to == from) break;
    }
    std::vector<int> rank(size_t(count), 0);
    const Crowd first = crowd;
    const int points = int(std::count(first.chosen.begin(), first.chosen.end(), true));
    for (int n = points - 1; n >= 0; --n) {
        const int place = crowd.tightestCluster();
        rank[size_t(place)] = n;
        crowd.flip(place);
    }
    crowd = first;
    for (int n = points; n < count; ++n) {
        const int place = crowd.largestVoid();
        rank[size_t(place)] = n;
        crowd.flip(place);
    }
    std::vector<uint8_t> tile(size_t(count), 0);
    for (int i = 0; i < count; ++i) tile[size_t(i)] = uint8_t(rank[size_t(i)] * 256 / count);
    return tile;
}

}  // namespace rubble
