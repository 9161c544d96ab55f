#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Makes a body.
void apply(EditContext& context, const CreateBodyEdit& edit);
/// Makes a shape on a body.
void apply(EditContext& context, const CreateShapeEdit& edit);
/// Refuses the shapes that this step made and that never had a voxel; the world ends around the others where they are
/// now. To be called when all edits are carried out.
void settlePlacedShapes(EditContext& context);

}  // namespace rubble
