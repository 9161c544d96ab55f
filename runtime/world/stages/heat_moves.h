#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Gives the heat of bricks that were split to their parts, by their shares of the voxels that are left. To be called
/// when the pieces exist and the parent still does.
void moveHeat(EditContext& context, const ShapeSplit& split);
/// Forgets the heat of a shape that is about to go or gets another frame of cells.
void dropHeat(EditContext& context, ShapeHandle shape);

}  // namespace rubble
