#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/core/pose.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/world.h"

namespace rubble {

/// What one step changed for the shadow volume. Values only; bricks are shared by reference.
struct ShadowStep {
    struct NewShape {
        ShapeHandle shape;
        VoxelGrid grid;
        PaletteRef palette;
        double voxelSize;  ///< metres
        Pose pose;         ///< grid corner -> world
    };
    struct ShapePalette {
        ShapeHandle shape;
        PaletteRef palette;
    };
    struct ShapePose {
        ShapeHandle shape;
        Pose pose;
        bool asleep;
    };
    uint64_t version = 0;
    uint64_t epoch = 0;  ///< number of levels loaded before it
    bool replacesAll = false;
    std::vector<ShapeHandle> destroyed;
    std::vector<NewShape> created;
    std::vector<BrickChange> bricks;
    std::vector<ShapePalette> palettes;
    std::vector<ShapePose> poses;
};

/// [main-thread] Copies out of the world what the step changed.
ShadowStep makeShadowStep(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world);

}  // namespace rubble
