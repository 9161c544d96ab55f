// A car drives through a house: in by one gable, out by the other, and round it to a stop.
#include "samples/scenes/car.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/house.h"
#include "samples/scenes/lamp.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/recipes.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"

namespace rubble::scenes {
namespace {

constexpr ivec3 kHouse{210, 0, 140};
constexpr int kWide = 84, kDeep = 84, kLane = kHouse.z + kDeep / 2;  // cells; the middle of the lane that the car takes

Level driveLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {480, 0, 360};
    ground.areas = {area(Concrete, 0, kLane - 22, 480, kLane + 22), area(Road, 0, 280, 480, 330), area(Paving, 0, 270, 480, 280)};
    ground.lanesAlongX = {{{0, 0, 304}, {480, 0, 306}}};
    Level level = makePlot("drive", ground, seed);
    addDrivenCar(level, "driven car", kCarRed, {14, 0, kLane - 9}, 1.0);
    HouseStyle style;
    style.width = kWide;
    style.depth = kDeep;
    style.rooms = false;
    style.wall = &kBrickYellow;
    style.roof = &kRoofTileRed;
    addHouse(level, "house", kHouse, style);
    for (int i = 0; i < 5; ++i) addLoose(level, makeCrate("crate " + std::to_string(i)), {346 + i % 2 * 10, i / 2 * 8, kLane - 8 + i % 2 * 3});
    addLoose(level, makeTable("table"), {kHouse.x + 40, 2, kLane - 8});
    addLoose(level, makeBench("bench"), {150, 0, kLane + 34}, Turn::Askew);
    addStreetLamp(level, "lamp", {120, 0, 266}, false);
    addLoose(level, makeCar("parked car", kCarBlue), {330, -kRoadDrop, 284});
    return level;
}

/// The level's bodies have the slots of their places in it.
BodyHandle drivenCar() {
    const Level level = driveLevel(0);
    for (uint32_t i = 0; i < level.bodies.size(); ++i)
        if (level.bodies[i].name == "driven car") return BodyHandle::make(1, 1, i);
    return {};
}

Edits driveScript(int step, uint64_t) {
    static const BodyHandle kCar = drivenCar();
    const double seconds = step / 60.0;
    if (seconds < 5.2) return {DriveEdit{kCar, 1.0, 0.0, 0.0}};
    if (seconds < 6.4) return {DriveEdit{kCar, 0.3, -1.0, 0.0}};
    return {DriveEdit{kCar, 0.0, -0.4, 1.0}};
}

Pose driveCamera(double seconds) {
    return lookAt({9.0 + 1.6 * seconds, 4.2, 37.0}, {17.0 + 1.5 * seconds, 2.6, 18.5});
}

}  // namespace

Scene driveScene() {
    Scene scene{"drive", "a car drives through a house", driveLevel, driveScript, driveCamera};
    scene.verticalFov = 0.75f;
    scene.steps = 540;
    scene.settings.impactThreshold = 8000.0;  // what a tyre rolls over breaks nothing, fifteen tonnes in a wall do
    scene.settings.impactRadius = 0.4;
    scene.settings.impactRadiusLimit = 1.4;
    scene.settings.load.on = true;
    return scene;
}

}  // namespace rubble::scenes
