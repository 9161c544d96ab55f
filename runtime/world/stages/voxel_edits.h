#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Gives the cells of a box other voxels.
void apply(EditContext& context, const WriteVoxelsEdit& edit);
/// Erases a shape.
void apply(EditContext& context, const DestroyShapeEdit& edit);

}  // namespace rubble
