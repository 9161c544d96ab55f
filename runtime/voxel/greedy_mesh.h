#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/voxel/palette.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

// Meshes of bricks for renderers that rasterise.
//
// A face of a voxel is seen if the cell beyond it is empty, or holds a voxel that can be seen through while this one
// cannot: an opaque voxel is hidden by opaque ones only, any other by all. Faces of one slice that have the same
// palette index and paint are merged greedily to rectangles (M. Lysenko, Meshing in a Minecraft Game, 2012), by bits: a
// layer of a brick is a word, and what is seen of all faces at a side is a few operations on eight words. Rectangles
// end at their brick, whose mesh depends on itself and the six bricks beside it and on nothing else.
//
// The faces of all bricks together cover each seen face once: they close every surface, with no gap and no overlap.
// They have T-junctions, as all greedy meshes do: corners lie on edges of other rectangles. All corners are whole
// numbers of cells, so a renderer whose transform moves equal points alike shows no crack but where rounding puts a
// pixel between the two.

/// A rectangle of faces of voxels that look alike.
struct FaceQuad {
    uint8_t side;                 ///< -x +x -y +y -z +z: 0 to 5, where the faces look
    uint8_t layer;                ///< of the voxels along that axis, in the brick: 0 to 7
    uint8_t u, v, width, height;  ///< in the brick, in cells along the two other axes, which follow cyclically: x y z x
    uint8_t entry;                ///< of the palette
    uint8_t paint;                ///< of the paint layer; 0: none
};

/// The most rectangles that a brick can have: every other voxel with all of its faces.
inline constexpr size_t kMaxBrickQuads = 6 * kBrickVoxels / 2;

/// Which entries of a palette cannot be seen through.
struct OpaqueEntries {
    /// By the opacity of the entries.
    explicit OpaqueEntries(const Palette& palette);
    std::array<bool, 256> opaque{};
    bool all = true;
};

/// Appends the rectangles of a brick of a grid, by entry and paint as they are met, then by side; none for an empty
/// brick.
void meshBrick(const VoxelGrid& grid, glm::ivec3 brick, const OpaqueEntries& entries, std::vector<FaceQuad>& out);

/// The corners of a rectangle in cells of the grid, counter-clockwise seen from where it looks.
std::array<glm::ivec3, 4> cornersOf(const FaceQuad& quad, glm::ivec3 brick);

}  // namespace rubble
