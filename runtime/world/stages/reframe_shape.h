#pragma once
#include "runtime/voxel/cell_box.h"
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Gives a shape's grid another box of cells, in those it has now; voxels outside are removed. The shape stays where it
/// is in the world, and the journal lists it as destroyed and then as created. Heat is dropped. False if the box is
/// refused (and logged), or if nothing is left of the shape, which is then destroyed.
bool reframeShape(EditContext& context, ShapeHandle shape, const CellBox& box);

}  // namespace rubble
