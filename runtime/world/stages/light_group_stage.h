#pragma once
#include "runtime/world/stages/edit_context.h"
#include "runtime/world/stages/entry_counts.h"

namespace rubble {

/// Counts the voxels that light groups lost in this step. A group that lost too many, or its power supply, flickers for
/// LightGroup::flickerSteps and then goes out with its lights and its glowing voxels.
void updateLightGroups(EditContext& context);

/// Takes the voxels that light groups lost in this step out of their accounts: no group begins to fail by it.
void forgetLostVoxels(EditContext& context);

/// Counts voxels that an edit made, by entry of their palette, in the light groups that they glow with. What a group
/// lost in this step and has again is not lost.
void countMade(EditContext& context, const Palette& palette, const EntryCounts& made);

/// Moves the supplies of light groups that are on `from` to the cells of `into` that lie there now. `offset`: the cell
/// of `into` at which cell 0 of `from` was.
void moveSupplies(EditContext& context, ShapeHandle from, ShapeHandle into, glm::ivec3 offset);

/// Makes a light group.
void apply(EditContext& context, const CreateLightGroupEdit& edit);
/// Switches a light group, or changes what puts it out.
void apply(EditContext& context, const SetLightGroupEdit& edit);

}  // namespace rubble
