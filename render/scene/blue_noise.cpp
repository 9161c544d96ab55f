#include "render/scene/blue_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/core/random.h"

namespace rubble {
namespace {

constexpr int kCount = kBlueNoiseSize * kBlueNoiseSize;

/// The points chosen so far and how crowded each place is: a sum of Gaussians on the torus.
struct Crowd {
    std::vector<bool> chosen = std::vector<bool>(kCount);
    std::vector<float> energy = std::vector<float>(kCount);
    std::array<float, kCount> kernel;

    Crowd() {
        for (int i = 0; i < kCount; ++i) {
            const int x = std::min(i % kBlueNoiseSize, kBlueNoiseSize - i % kBlueNoiseSize);
            const int y = std::min(i / kBlueNoiseSize, kBlueNoiseSize - i / kBlueNoiseSize);
            kernel[size_t(i)] = std::exp(-float(x * x + y * y) / (2.0f * 1.9f * 1.9f));
        }
    }
    void flip(int place) {
        const float sign = chosen[size_t(place)] ? -1.0f : 1.0f;
        chosen[size_t(place)] = !chosen[size_t(place)];
        const int px = place % kBlueNoiseSize, py = place / kBlueNoiseSize;
        for (int y = 0; y < kBlueNoiseSize; ++y)
            for (int x = 0; x < kBlueNoiseSize; ++x) {
                const int dx = (x - px) & (kBlueNoiseSize - 1), dy = (y - py) & (kBlueNoiseSize - 1);
                energy[size_t(y * kBlueNoiseSize + x)] += sign * kernel[size_t(dy * kBlueNoiseSize + dx)];
            }
    }
    int tightestCluster() const { return extreme(true, -1.0f); }
    int largestVoid() const { return extreme(false, 1.0f); }

private:
    int extreme(bool among, float sign) const {
        int best = -1;
        for (int i = 0; i < kCount; ++i)
            if (chosen[size_t(i)] == among && (best < 0 || sign * energy[size_t(i)] < sign * energy[size_t(best)])) best = i;
        return best;
    }
};

}  // namespace

std::vector<uint8_t> makeBlueNoise() {
    Crowd crowd;
    Random random(7);
    for (int i = 0; i < kCount / 10; ++i) {
        const int place = int(random.below(kCount));
        if (!crowd.chosen[size_t(place)]) crowd.flip(place);
    }
    for (int moved = 0; moved < kCount; ++moved) {  // spread the first points until the tightest is also the loneliest place
        const int from = crowd.tightestCluster();
        crowd.flip(from);
        const int to = crowd.largestVoid();
        crowd.flip(to);
        if (to == from) break;
    }
    std::vector<int> rank(kCount);
    const Crowd first = crowd;
    const int points = int(std::count(first.chosen.begin(), first.chosen.end(), true));
    for (int n = points - 1; n >= 0; --n) {
        const int place = crowd.tightestCluster();
        rank[size_t(place)] = n;
        crowd.flip(place);
    }
    crowd = first;
    for (int n = points; n < kCount; ++n) {
        const int place = crowd.largestVoid();
        rank[size_t(place)] = n;
        crowd.flip(place);
    }
    std::vector<uint8_t> tile(kCount);
    for (int i = 0; i < kCount; ++i) tile[size_t(i)] = uint8_t(rank[size_t(i)] * 256 / kCount);
    return tile;
}

}  // namespace rubble
