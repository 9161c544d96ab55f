#pragma once
#include <string>
#include <vector>

#include "runtime/world/level/level.h"
#include "tests/benchmark/world_rays/rays.h"

namespace rubble::rays {

/// A level, its shadow volume and views of it.
struct RayScene {
    std::string name;
    Level level;
    WorldBits bits;
    std::vector<ShadowPatch> patches;
    std::vector<RayView> views;
};

/// The sandbox town.
RayScene townScene();
/// Streets 6 m wide and blocks of houses with rooms, windows and walls one cell thick, poles and trees, in 1024 x 256 x
/// 1024 cells.
RayScene cityScene();
/// `blocks` x `blocks` of these cities, up to 4 x 4: a volume of 4 billion voxels.
RayScene wideCityScene(int blocks);
/// A model of the tests (tests/support/models.h); without views if it is missing.
RayScene modelScene();

}  // namespace rubble::rays
