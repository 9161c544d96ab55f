// A chapel whose stained glass colours the sunlight on its floor, until a charge opens the wall.
#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/neighbourhood.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kWidth = 92, kLength = 120, kHeight = 52, kWall = 4;  // cells
constexpr int kFloor = kFooting + 2;
constexpr ivec3 kChapel{110, -kFooting, 90};

constexpr int kWindows = 3, kLight = 18, kSill = 9, kSpring = 32, kGap = 16;  // of the sunlit wall, in cells
constexpr int windowAt(int i) {
    return 14 + i * (kLight + kGap);
}

/// Whether a cell (along the wall, up) lies inside the pointed arch of a window.
bool inWindow(int along, int up) {
    for (int i = 0; i < kWindows; ++i) {
        const int x = along - windowAt(i);
        if (x < 0 || x >= kLight || up < kSill) continue;
        if (up < kSpring) return true;
        const int left = x, right = kLight - 1 - x,
                  above = up - kSpring;  // two circles, each around the foot of the other side
        return left * left + above * above < kLight * kLight && right * right + above * above < kLight * kLight;
    }
    return false;
}

/// Stained glass: panes in lead, a lozenge pattern with a medallion in each window.
void addGlass(Canvas& c, int x, int kFloorAt) {
    const std::array<Swatch, 6> colors = {c.addSurface(kGlassRed),    c.addSurface(kGlassBlue),
                                          c.addSurface(kGlassGold),   c.addSurface(kGlassGreen),
                                          c.addSurface(kGlassViolet), c.addSurface(kGlass)};
    const Swatch lead = c.addSurface(kDarkSteel);
    for (int z = 0; z < kLength; ++z)
        for (int y = 0; y < kHeight; ++y) {
            if (!inWindow(z, y)) continue;
            const int window = (z - windowAt(0)) / (kLight + kGap);
            const int u = z - windowAt(window) - kLight / 2, v = y - 22;
            const bool isRim = !inWindow(z - 1, y) || !inWindow(z + 1, y) || !inWindow(z, y - 1) || !inWindow(z, y + 1);
            const int range = u * u + v * v;
            const int a = (u + v + 600) / 6, b = (u - v + 600) / 6;
            const bool isLead = isRim || (range >= 36 && range < 49) ||
                                (range >= 49 && ((u + v + 600) % 6 == 0 || (u - v + 600) % 6 == 0));
            Swatch glass = colors[hashCell(a, b, window, 7) % 5];
            if (range < 36) glass = colors[size_t((window + (range < 9 ? 2 : 0)) % 3)];
            if (range >= 49 && hashCell(a, b, window, 9) % 4 == 0) glass = colors[5];
            c.set({x, kFloorAt + y, z}, isLead ? lead : glass);
        }
}

void addChapel(Level& level) {
    Canvas c({kWidth, kFloor + kHeight + 36, kLength});
    const Swatch stone = c.addSurface(kRender), base = c.addSurface(kConcrete), joint = c.addSurface(kPavingJoint),
                 flag = c.addSurface(kPaving), beam = c.addSurface(kDarkWood), tile = c.addSurface(kRoofTile);
    const int top = kFloor + kHeight;
    c.box({0, 0, 0}, {kWidth, kFloor, kLength}, base);
    c.fill({kWall, kFloor - 1, kWall}, {kWidth - kWall, kFloor, kLength - kWall}, [&](ivec3 cell) {
        return PaletteBuilder::pick(cell.x % 8 == 0 || (cell.z + cell.x / 8 % 2 * 4) % 8 == 0 ? joint : flag, cell);
    });
    c.box({0, kFloor, 0}, {kWall, top, kLength}, stone);
    c.box({kWidth - kWall, kFloor, 0}, {kWidth, top, kLength}, stone);
    c.box({0, kFloor, 0}, {kWidth, top, kWall}, stone);
    c.box({0, kFloor, kLength - kWall}, {kWidth, top, kLength}, stone);
    for (int z = 0; z < kLength; ++z)
        for (int y = 0; y < kHeight; ++y)
            if (inWindow(z, y)) c.clear({0, kFloor + y, z}, {kWall, kFloor + y + 1, z + 1});
    addGlass(c, kWall / 2, kFloor);
    // A steep roof over open beams.
    for (int i = 0; i < kWidth / 2; ++i) {
        const int y = top + i * 3 / 4;
        for (const int x : {i, kWidth - 1 - i}) c.box({x, y, 0}, {x + 1, y + 2, kLength}, tile);
        for (const int x : {i, kWidth - 1 - i})
            for (const int z : {0, kLength - kWall}) c.box({x, top, z}, {x + 1, y, z + kWall}, stone);
    }
    for (int z = 12; z < kLength; z += 24) c.box({0, top - 2, z}, {kWidth, top + 2, z + 3}, beam);
    c.clear({kWidth / 2 - 8, kFloor, 0}, {kWidth / 2 + 8, kFloor + 24, kWall});
    addStatic(level, c.finish("chapel"), kChapel);
}

Level chapelLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {320, 0, 320};
    ground.areas = {area(Paving, 146, 0, 166, 90)};
    Level level = makePlot("chapel", ground, seed);
    addChapel(level);
    level.environment.exposure *= 1.5f;  // for the dim interior
    const ivec3 floor = kChapel + ivec3(0, kFloor, 0);
    for (int row = 0; row < 4; ++row)
        addDynamic(level, makeBench("pew " + std::to_string(row + 1)), floor + ivec3(56, 0, 30 + row * 18));
    addDynamic(level, makeTable("altar"), floor + ivec3(38, 0, kLength - 24));
    return level;
}

Edits chapelScript(int step, uint64_t) {
    ScriptClock clock(step);
    const glm::dvec3 window(kChapel.x + kWall / 2, kChapel.y + kFloor + 20, kChapel.z + windowAt(1) + kLight / 2);
    if (clock.at(1.0)) clock.add(ExplodeEdit{.position = atCell(window.x - 6, window.y, window.z), .size = 1.7});
    return clock.take();
}

Pose chapelCamera(double seconds) {
    return lookAt({19.2 - 0.1 * seconds, 2.6, 10.2}, {13.4, 1.2, 15.6});
}

}  // namespace

Scene chapelScene() {
    Scene scene{"chapel", "stained glass that colours the floor, until the wall opens", chapelLevel, chapelScript,
                chapelCamera};
    scene.steps = 240;
    scene.verticalFov = 1.1f;
    return scene;
}

}  // namespace rubble::scenes
