#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Makes pieces of the fragments that broke out of shapes in this step: they are in no grid any more. To be called
/// before a shape's frame of cells changes.
void releaseFragments(EditContext& context);

/// Erases the shapes that have lost their last voxel, and tests no other for what came off.
void dropEmptyShapes(EditContext& context);

/// Tests which shapes that lost voxels are still connected, and makes pieces of what came off. Takes up to
/// SplitSettings::partsPerStep parts of work; shapes beyond that wait in line for the next step.
void splitShapes(EditContext& context);

}  // namespace rubble
