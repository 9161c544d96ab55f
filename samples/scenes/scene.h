#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "runtime/world/level/level.h"
#include "runtime/world/world.h"

namespace rubble {

/// A scripted scene: a level, the edits of each step, and a camera. Samples, tests and benchmarks share the scenes.
/// All functions are pure; steps of 1/60 s count from 0.
struct Scene {
    std::string_view name;                     ///< as `--scene` takes it
    std::string_view description;              ///< one line for people
    Level (*level)(uint64_t seed);             ///< builds the level
    Edits (*script)(int step, uint64_t seed);  ///< edits of a step
    Pose (*camera)(double seconds);            ///< pose of the camera
    float verticalFov = 0.70f;                 ///< radians
    int steps = 480;                           ///< length of the scene
    WorldSettings settings{};                  ///< settings of its world
};

/// All scripted scenes, in the order in which `--list-scenes` prints them.
std::span<const Scene> allScenes();
/// The scene of a name; null if there is none.
const Scene* findScene(std::string_view name);

/// The scenes, each in a file of its own; the comment at the top of that file says what happens in the scene.
namespace scenes {
Scene towerScene();      ///< `tower_scene.cpp`
Scene bridgeScene();     ///< `bridge_scene.cpp`
Scene fireScene();       ///< `fire_scene.cpp`
Scene wallScene();       ///< `wall_scene.cpp`
Scene paneScene();       ///< `pane_scene.cpp`
Scene lightShopScene();  ///< `light_shop_scene.cpp`
Scene dominoesScene();   ///< `dominoes_scene.cpp`
Scene cratersScene();    ///< `craters_scene.cpp`
Scene crushScene();      ///< `crush_scene.cpp`
Scene gardenScene();     ///< `garden_scene.cpp`
Scene craneScene();      ///< `crane_scene.cpp`
Scene dominoRunScene();  ///< `domino_run_scene.cpp`
Scene raftScene();       ///< `raft_scene.cpp`
Scene driveScene();      ///< `drive_scene.cpp`
Scene lightsScene();     ///< `lights_scene.cpp`
Scene chapelScene();     ///< `chapel_scene.cpp`
Scene mechanicsScene();  ///< `mechanics_scene.cpp`
}  // namespace scenes

}  // namespace rubble
