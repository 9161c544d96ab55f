#pragma once
#include <cstdint>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/voxel/cell_box.h"

namespace rubble {

// Edits of a shape as a whole. A shape whose grid gets another box of cells keeps its handle and its place in the
// world; the journal lists it as destroyed and then as created.

/// Makes a shape of each connected component; all stay on the body. The one with an anchor, else the largest, keeps the
/// handle. Unanchored shapes of a static body stay in place until they are cut.
struct SplitShapeEdit {
    ShapeHandle shape;
    bool removeResidual = false;  ///< components below `residualVoxels` are removed
    uint64_t residualVoxels = 64;
};

/// Adds a shape to another one of the same body, voxel size and rotation that it touches face to face. Where both have
/// a voxel, `into` keeps its own. Refused, and logged, if their cells do not line up or their palettes need more than
/// 255 entries.
struct MergeShapeEdit {
    ShapeHandle shape;
    ShapeHandle into;  ///< empty: the first shape of the body that fits
};

/// Shrinks a shape's grid to its voxels.
struct TrimShapeEdit {
    ShapeHandle shape;
};

/// Gives a shape's grid another box of cells, in coordinates of its present cells; voxels outside are removed.
struct ResizeShapeEdit {
    ShapeHandle shape;
    CellBox box;
};

/// Gives cells of a box other voxels; the box lies within the grid. Voxels that touch no others come off.
struct WriteVoxelsEdit {
    ShapeHandle shape;
    CellBox box;
    std::vector<uint8_t> entries;  ///< of the palette, 0: none; a byte each cell: x fastest, then y, then z
    std::vector<uint8_t> mask;     ///< a byte each cell, 0: it stays as it is; empty: all cells are written
};

/// What holds a static shape from an edit on.
enum class AnchorChange : uint8_t {
    None,     ///< what did before
    Boxes,    ///< those of the edit: what they do not hold comes off in this step
    Default,  ///< its lowest layer: see anchorByDefault()
};

/// Changes what a shape is beside its voxels.
struct SetShapeEdit {
    ShapeHandle shape;
    bool setsStrength = false;  ///< else `strength` is not read, and so on
    float strength = 1.0f;      ///< see Shape, as for what follows
    bool setsDensity = false;
    float density = 1.0f;
    bool setsEmission = false;
    float emission = 1.0f;
    bool setsLoad = false;
    bool loadBearing = true;
    AnchorChange anchorChange = AnchorChange::None;
    std::vector<CellBox> anchors;  ///< AnchorChange::Boxes
};

/// Erases a shape with its voxels, without dust or pieces; its body too, if that has no other.
struct DestroyShapeEdit {
    ShapeHandle shape;
};

}  // namespace rubble
