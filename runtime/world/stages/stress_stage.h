#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Opens the cracks that the last step's analyses found, like any other cut. Stress must be on.
void openCracks(EditContext& context);
/// Removes the cells of a crack and lists it in the journal.
void openCrack(EditContext& context, ShapeHandle shape, const StrengthTable& entries, const StressCrack& crack);
/// Tells the analyses what this step changed, and runs them for up to StressSettings::workPerStep. Stress must be on.
void runStressAnalysis(EditContext& context);
/// Tells a shape's analysis how much of a brick's strength fire has left, of 256; see quantizedStrength(). Stress must
/// be on.
void weakenBrick(EditContext& context, ShapeHandle shape, glm::ivec3 brick, int left);

}  // namespace rubble
