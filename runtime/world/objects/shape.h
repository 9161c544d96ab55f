#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/mass_properties.h"
#include "runtime/voxel/paint_colors.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"
#include "runtime/world/objects/collision_shape.h"

namespace rubble {

/// A voxel grid on a body.
struct Shape {
    std::string name;
    BodyHandle body;
    Pose local;              ///< in its body; the grid's corner is the origin
    float voxelSize = 0.1f;  ///< metres
    VoxelGrid grid;
    PaletteRef palette;
    PaintColorsRef paintColors;    ///< null: nothing is painted
    MassMoments moments;           ///< of the grid, always up to date
    std::vector<CellBox> anchors;  ///< cells of the grid that hold a static shape to the world
    std::vector<std::string> tags;
    bool isPiece = false;         ///< came off another shape, or lost its last anchor
    bool broken = false;          ///< has lost voxels
    bool knownConnected = false;  ///< connected since its last split: only the surroundings of a cut need a test
    bool loadBearing = true;      ///< false: left out of the stress analysis
    float strength = 1.0f;        ///< multiple of its materials' strengths
    float density = 1.0f;         ///< multiple of its materials' densities, which `moments` are without
    float emission = 1.0f;        ///< multiple of what its palette's entries emit
    uint8_t collisionLayer = 1;   ///< bits; two shapes touch if each one's layer is in the other's mask
    uint8_t collisionMask = 255;
    CollisionShape collisionShape = CollisionShape::Voxels;  ///< what it is touched as
};

}  // namespace rubble
