#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "runtime/world/level/level.h"
#include "runtime/world/world.h"

namespace rubble {

/// A level, what happens to it step by step, and where to watch it from: the same for samples, tests and benchmarks.
/// All functions are pure; steps are 1/60 s from 0.
struct Scene {
    std::string_view name;         ///< as commands take it
    std::string_view description;  ///< one line for people
    Level (*level)(uint64_t seed);
    Edits (*script)(int step, uint64_t seed);
    Pose (*camera)(double seconds);
    float verticalFov = 0.70f;  ///< radians
    int steps = 480;            ///< until everything worth seeing has happened
    WorldSettings settings{};   ///< how its world breaks
};

/// The scripted scenes, in the order that people should see them.
std::span<const Scene> allScenes();
/// Null if there is none of that name.
const Scene* findScene(std::string_view name);

/// One function for each, in a file of its own.
namespace scenes {
Scene towerScene();
Scene bridgeScene();
Scene fireScene();
Scene wallScene();
Scene paneScene();
Scene lightShopScene();
Scene dominoesScene();
Scene cratersScene();
Scene crushScene();
Scene gardenScene();
Scene craneScene();
Scene dominoRunScene();
Scene raftScene();
Scene driveScene();
Scene lightsScene();
Scene chapelScene();
}  // namespace scenes

}  // namespace rubble
