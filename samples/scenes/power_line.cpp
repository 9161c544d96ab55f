#include "samples/scenes/power_line.h"

#include <algorithm>

#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kFoot = 5, kHeight = 68;    // depth in the ground; height over it
constexpr int kMiddle = 20, kDepth = 30;  // z of the poles' low sides, and of the whole shape
constexpr int kCableTop = kFoot + kHeight - 2, kSag = 7;
constexpr int kHead = kFoot + 46;  // of the lights
constexpr const char* kName = "power line";

struct LineSwatches {
    explicit LineSwatches(Canvas& c)
        : wood(c.addSurface(kTimber, 78)),
          iron(c.addSurface(kDarkSteel)),
          enamel(c.addSurface(kWhiteEnamel)),
          cable(c.addSurface(kCable)),
          tank(c.addSurface(kTankPaint, 88)) {}
    Swatch wood, iron, enamel, cable, tank;
};

/// Cells of a cable between two poles, as a parabola of face-connected cells.
void drawCable(Canvas& c, int from, int spacing, int z, Swatch cable) {
    const auto height = [&](int x) {
        return kCableTop - 4 * kSag * (x - from) * (from + spacing - x) / (spacing * spacing);
    };
    for (int x = from; x <= from + spacing; ++x) {
        const int y = height(x), before = x > from ? height(x - 1) : y;
        c.box({x, std::min(y, before), z}, {x + 1, std::max(y, before) + 1, z + 1}, cable);
    }
}

/// A pole with a cross arm, insulators, and a light on an arm toward low z, fed by a wire down the pole.
void drawPole(Level& level, Canvas& c, int x, int number, const LineSwatches& s) {
    c.box({x - 1, 0, kMiddle}, {x + 2, kFoot + kHeight, kMiddle + 3}, s.wood);
    c.box({x - 1, kFoot + kHeight - 6, kMiddle - 8}, {x + 2, kFoot + kHeight - 4, kMiddle + 10}, s.wood);
    for (const int z : {kMiddle - 7, kMiddle + 8})
        c.box({x, kFoot + kHeight - 4, z}, {x + 1, kCableTop, z + 1}, s.enamel);
    const uint32_t group = addLightGroup(level, std::string(kName) + " light " + std::to_string(number), 0.5f);
    LightGroup& record = level.lightGroups[group - 1];
    record.supplyShape = kName;
    record.supplyCell = {1, kCableTop, kMiddle - 7};
    const Swatch glow = c.addSurface(kStreetLightGlow, 100, group);
    c.box({x, kHead + 2, 6}, {x + 1, kHead + 4, kMiddle}, s.iron);
    c.bar({x, kHead - 6, kMiddle - 1}, {x, kHead + 1, kMiddle - 8}, 1, s.iron);
    c.box({x - 2, kHead + 2, 2}, {x + 3, kHead + 4, 12}, s.iron);
    c.box({x - 2, kHead, 2}, {x + 3, kHead + 2, 12}, glow);
    c.box({x, kHead + 4, kMiddle - 7}, {x + 1, kCableTop + 1, kMiddle - 6}, s.cable);  // down from the cable
    c.box({x, kHead + 4, 8}, {x + 1, kHead + 5, kMiddle - 6}, s.cable);
    c.box({x, kHead + 2, 8}, {x + 1, kHead + 5, 9}, s.cable);  // into the light
    addLight(level, kName, group, LightKind::Cone, glm::dvec3(x + 0.5, kHead - 0.8, 7.0), kWarmLight * 240.0f, 15.0f,
             0.18f);
}

}  // namespace

void addPowerLine(Level& level, ivec3 cell, int poles, int spacing) {
    Canvas c({(poles - 1) * spacing + 10, kFoot + kHeight + 1, kDepth});
    const LineSwatches s(c);
    for (int i = 0; i < poles; ++i) drawPole(level, c, 3 + i * spacing, i + 1, s);
    for (int i = 0; i + 1 < poles; ++i)
        for (const int z : {kMiddle - 7, kMiddle + 8}) drawCable(c, 3 + i * spacing, spacing, z, s.cable);
    c.box({1, kCableTop, kMiddle - 7}, {4, kCableTop + 1, kMiddle - 6}, s.cable);  // where the power comes in
    c.box({5, kFoot + 44, kMiddle - 2}, {10, kFoot + 56, kMiddle + 5}, s.tank);
    c.box({4, kFoot + 50, kMiddle + 1}, {5, kFoot + 52, kMiddle + 2}, s.iron);
    LevelShape line = c.finish(kName);
    line.loadBearing = false;  // its cables are one voxel thick, too thin for the stress analysis
    addStatic(level, std::move(line), cell - ivec3(3, kFoot, kMiddle));
}

}  // namespace rubble::scenes
