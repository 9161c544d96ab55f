#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Replaces sky, sun, air, exposure or gravity if the numbers are valid.
void apply(EditContext& context, const SetEnvironmentEdit& edit);
/// Adds a light if its numbers are valid; FrameChanges::lightsAdded gets its handle, or an empty one.
void apply(EditContext& context, const AddLightEdit& edit);
/// Gives a light other values if they are valid.
void apply(EditContext& context, const SetLightEdit& edit);
/// Erases a light.
void apply(EditContext& context, const RemoveLightEdit& edit);

/// Moves lights of a split shape to the piece that has the voxel nearest to them; of equals the parent, then the first
/// child.
void moveLights(EditContext& context, const ShapeSplit& split);
/// Turns off the lights of a shape that is about to go; they stay in the world where they are.
void turnOffLightsOf(EditContext& context, ShapeHandle shape);

}  // namespace rubble
