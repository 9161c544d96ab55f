// A tower crane turns its jib, and the wrecking ball on its rope swings through a brick house.
#include "samples/scenes/crane.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/house.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr ivec3 kMast{185, 0, 262};  // low corner

Level craneLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {440, 0, 420};
    ground.areas = {area(Paving, 150, 236, 440, 300), area(Earth, 160, 244, 230, 292), area(Road, 0, 310, 440, 420),
                    area(Concrete, 0, 300, 440, 310)};
    ground.lanesAlongX = {{{0, 0, 364}, {440, 0, 366}}};
    Level level = makePlot("crane", ground, seed);
    HouseStyle style;
    style.rooms = false;
    addHouse(level, "house", {272, 0, 118}, style);
    addCrane(level, kMast, 0.28);
    for (int i = 0; i < 6; ++i)
        addDynamic(level, makeCrate("crate " + std::to_string(i)), {110 + i % 3 * 11, i / 3 * 8, 262});
    addDynamic(level, makeBarrel("barrel 1", kCarRed), {150, 0, 280});
    addDynamic(level, makeBarrel("barrel 2", kCarBlue), {158, 0, 276});
    return level;
}

Edits craneScript(int, uint64_t) {
    return {};  // the crane's motor turns from the start
}

Pose craneCamera(double seconds) {
    return lookAt({12.0 + 0.25 * seconds, 6.4, 48.5}, {25.0, 6.0, 21.0});
}

}  // namespace

Scene craneScene() {
    Scene scene{"crane", "a tower crane swings a wrecking ball through a house", craneLevel, craneScript, craneCamera};
    scene.verticalFov = 0.92f;
    scene.steps = 720;
    scene.settings.impactRadius = 0.5;
    scene.settings.impactRadiusLimit = 2.0;
    scene.settings.stress.on = true;
    return scene;
}

}  // namespace rubble::scenes
