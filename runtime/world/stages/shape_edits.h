#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Makes a shape of each connected component; all stay on the body.
void apply(EditContext& context, const SplitShapeEdit& edit);
/// Adds a shape to another one of the same body whose cells line up with its own and that it touches.
void apply(EditContext& context, const MergeShapeEdit& edit);
/// Takes the empty margins off a shape's grid.
void apply(EditContext& context, const TrimShapeEdit& edit);
/// Gives a shape's grid another box of cells.
void apply(EditContext& context, const ResizeShapeEdit& edit);

/// Changes what a shape is beside its voxels.
void apply(EditContext& context, const SetShapeEdit& edit);

}  // namespace rubble
