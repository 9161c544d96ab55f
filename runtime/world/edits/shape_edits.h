#pragma once
#include <cstdint>

#include "runtime/core/handle.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

// Edits of a shape as a whole. A shape that changes its frame of cells keeps its handle and its place in the world; the
// journal lists it as destroyed and, after that, as created.

/// Makes a shape of each component; all stay on the body. The one with an anchor, else the largest, keeps the handle.
/// What has no anchor on a static body stays until it is cut.
struct SplitShapeEdit {
    ShapeHandle shape;
    bool removeResidual = false;  ///< components below `residualVoxels` vanish: they count as removed
    uint64_t residualVoxels = 64;
};

/// Adds a shape to another of the same body, voxel size and rotation that it touches face to face. Where both have a
/// voxel, `into` keeps its own. Refused, with a log line, if they do not match or the palettes do not fit into one.
struct MergeShapeEdit {
    ShapeHandle shape;
    ShapeHandle into;  ///< empty: the first that matches
};

/// Takes the empty margins off a shape's grid.
struct TrimShapeEdit {
    ShapeHandle shape;
};

/// Gives a shape's grid another box of cells, in those it has now; voxels outside are removed.
struct ResizeShapeEdit {
    ShapeHandle shape;
    CellBox box;
};

}  // namespace rubble
