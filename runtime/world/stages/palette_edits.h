#pragma once
#include <span>
#include <string>

#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Replaces entries of a shape's palette, or of all palettes that are equal to it.
void apply(EditContext& context, const SetPaletteEdit& edit);

/// What the world has not that some of a palette's entries name; empty: nothing.
std::string paletteError(const WorldData& world, std::span<const PaletteEntry> entries);

/// Mass, strength and contacts of a shape follow its palette and the materials, and its body wakes.
void updateMatter(EditContext& context, ShapeHandle shape);

}  // namespace rubble
