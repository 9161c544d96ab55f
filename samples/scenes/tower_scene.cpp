// A tower of nine storeys is felled: charges destroy the columns on one side of its foot, and it tips over along the
// street.
#include "samples/scenes/car.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/office_tower.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/street_light.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr ivec3 kTower{64, 0, 118};  // low corner on the ground
constexpr int kSide = OfficeTower::kSide;
constexpr auto& kColumns = OfficeTower::kColumns;

Level towerLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {448, 0, 580};
    ground.areas = {area(Paving, 0, 108, 448, 210), area(Road, 0, 210, 448, 268), area(Earth, 214, 268, 236, 580),
                    area(Concrete, kTower.x - 6, kTower.z - 6, kTower.x + 70, 196)};
    ground.lanesAlongX = {{{0, 0, 238}, {448, 0, 240}}};
    Level level = makePlot("tower", ground, seed);
    addOfficeTower(level, kTower);
    addDynamic(level, makeCar("car red", kCarRed), {190, 0, 150}, Turn::Quarter);
    addDynamic(level, makeCar("car cream", kCarCream), {236, 0, 150}, Turn::Quarter);
    addDynamic(level, makeVan("van", kCarBlue), {282, -kRoadDrop, 216});
    addStatic(level, makeConcreteWall("wall", 96, 14), {330, -kFenceFoot, 120});
    addStreetLight(level, "street light 1", {170, 0, 204}, false);
    addStreetLight(level, "street light 2", {360, 0, 204}, false);
    for (int i = 0; i < 4; ++i)
        addDynamic(level, makeCrate("crate " + std::to_string(i)), {318 + i % 2 * 10, i / 2 * 8, 150});
    addDynamic(level, makeBench("bench"), {158, 0, 190});
    addDynamic(level, makeBin("bin"), {148, 0, 190});
    return level;
}

glm::dvec3 inTower(double x, double y, double z) {
    return (glm::dvec3(kTower) + glm::dvec3(x, y, z)) * kVoxel;
}

/// Carves a box from x0 to x1 and y0 to y1 through the whole depth of the ground floor, in cells of the tower.
CarveEdit notch(double x0, double x1, double y0, double y1) {
    CarveEdit edit;
    edit.kind = BrushKind::Box;
    edit.position = inTower((x0 + x1) / 2, (y0 + y1) / 2, kSide / 2.0);
    edit.halfSize = glm::dvec3((x1 - x0) / 2, (y1 - y0) / 2, kSide / 2.0 + 2) * kVoxel;
    return edit;
}

Edits towerScript(int step, uint64_t) {
    ScriptClock clock(step);
    // First the columns on the side that it shall fall to, then those in the middle; a notch removes what remains of
    // each.
    for (int i = 0; i < 3; ++i)
        if (clock.at(0.8 + 0.1 * i)) clock.add(ExplodeEdit{inTower(61.5, 9.0, kColumns[i] + 2.5), 1.7});
    if (clock.at(1.1)) clock.add(notch(46, 66, 4, 25));
    for (int i = 0; i < 3; ++i)
        if (clock.at(1.2 + 0.06 * i)) clock.add(ExplodeEdit{inTower(32.0, 8.0, kColumns[i] + 2.5), 1.6});
    if (clock.at(1.4)) clock.add(notch(12, 47, 5, 15));
    // A thin cut through the remaining columns makes the hinge.
    if (clock.at(1.6)) clock.add(notch(-2, 13, 6, 7.4));
    return clock.take();
}

Pose towerCamera(double seconds) {
    return lookAt({22.5 + 0.1 * seconds, 3.0, 48.0}, {17.5, 11.0, 15.0});
}

}  // namespace

Scene towerScene() {
    Scene scene{"tower", "a tower of nine storeys, felled at its foot", towerLevel, towerScript, towerCamera};
    scene.verticalFov = 0.86f;
    scene.steps = 480;
    scene.settings.stress.on = true;
    scene.settings.stress.contactTime = 0.0015;  // s; short, so that the tower breaks where it lands
    return scene;
}

}  // namespace rubble::scenes
