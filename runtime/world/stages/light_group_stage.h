#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Counts the voxels that light groups lost in this step. A group that lost too many, or its power supply, flickers for
/// LightGroup::flickerSteps and then goes out with its lights and its glowing voxels.
void updateLightGroups(EditContext& context);

/// Makes a light group.
void apply(EditContext& context, const CreateLightGroupEdit& edit);
/// Switches a light group, or changes what puts it out.
void apply(EditContext& context, const SetLightGroupEdit& edit);

}  // namespace rubble
