#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "runtime/core/random.h"
#include "samples/scenes/demolition.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/script_clock.h"

namespace rubble {
namespace {

using namespace scenes;
using glm::dvec3;

/// The model's bounds, and a size of tools that suits them.
struct Target {
    dvec3 low, high;
    dvec3 size() const { return high - low; }
    dvec3 at(double x, double y, double z) const { return low + size() * dvec3(x, y, z); }
    double tool() const { return std::clamp(0.11 * (size().x + size().y + size().z) / 1.5, 0.3, 2.2); }
};

/// A stripe of paint along the front and the sunlit side.
void spray(ScriptClock& clock, const Target& target) {
    constexpr std::array<uint8_t, 3> kPink{240, 30, 130}, kCyan{30, 190, 220};
    const double radius = target.tool() * 0.4;
    for (int i = clock.first(0.4, 30, 1.4); i < clock.last(0.4, 30, 1.4); ++i) {
        const double along = i / 29.0, wave = 0.45 + 0.1 * (i % 6 < 3 ? i % 6 : 6 - i % 6) / 3.0;
        clock.add(PaintEdit{target.at(along, wave, 0.97), radius, kPink, 200, 200, uint32_t(i)});
        clock.add(PaintEdit{target.at(0.03, wave, along), radius, kCyan, 200, 200, uint32_t(i + 100)});
    }
}

void hammer(ScriptClock& clock, const Target& target) {
    const double radius = target.tool() * 0.35;
    static constexpr double kHits[][3] = {
        {0.1, 0.5, 0.95}, {0.25, 0.7, 1.0}, {0.05, 0.6, 0.7}, {0.4, 0.35, 1.0}, {0.1, 0.85, 0.9}};
    for (int i = clock.first(1.4, 5, 1.8); i < clock.last(1.4, 5, 1.8); ++i)
        clock.add(carveSphere(target.at(kHits[i][0], kHits[i][1], kHits[i][2]), {radius, radius * 0.8, 0.0}));
}

void charge(ScriptClock& clock, const Target& target, double second, dvec3 share, double size) {
    if (clock.at(second)) clock.add(ExplodeEdit{target.at(share.x, share.y, share.z), 1.3 * size});
}

/// A horizontal cut through the whole model near its foot; everything above it falls.
void slice(ScriptClock& clock, const Target& target) {
    const double height = std::clamp(target.size().y * 0.2, 0.3, 3.0), radius = 0.13;
    const int rows = std::clamp(int(target.size().z / (1.3 * radius)) + 2, 2, 600);
    for (int i = clock.first(4.1, rows, 5.0); i < clock.last(4.1, rows, 5.0); ++i) {
        const double z = target.low.z + target.size().z * i / (rows - 1);
        clock.add(carveCapsule({target.low.x - 0.2, target.low.y + height, z},
                               {target.high.x + 0.2, target.low.y + height, z}, {radius, radius, radius}));
    }
}

}  // namespace

Edits demolishModel(int step, glm::dvec3 low, glm::dvec3 high, uint64_t seed) {
    ScriptClock clock(step);
    const Target target{low, high};
    spray(clock, target);
    hammer(clock, target);
    const double size = target.tool();
    charge(clock, target, 2.58, {0.04, 0.4, 0.6}, size);
    charge(clock, target, 3.47, {0.35, 0.6, 0.96}, size);
    slice(clock, target);
    Random random(seed);
    for (int i = 0; i < 6; ++i) {
        const double x = random.unit(), y = random.unit(), z = random.unit();
        charge(clock, target, 5.9 + i * 0.6, {0.1 + 0.8 * x, 0.1 + 0.5 * y, 0.1 + 0.8 * z}, size * 0.8);
    }
    return clock.take();
}

Pose modelCamera(glm::dvec3 low, glm::dvec3 high, double seconds) {
    const dvec3 center = (low + high) * 0.5;
    const double radius = std::max(glm::length(high - low) * 0.5, 1.5);
    const double distance = radius / std::tan(0.5 * kDemolitionFov);
    const dvec3 direction = glm::normalize(dvec3(-0.68 + 0.006 * seconds, 0.34, 0.72));
    return scenes::lookAt(center + direction * distance, center);
}

}  // namespace rubble
