#pragma once
#include <span>

#include "runtime/destruction/paint.h"
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Blends paint into the surface of every shape in reach, or of the one that the edit names.
void apply(EditContext& context, const PaintEdit& edit);
/// Blends paint into some cells of a shape, in the world's paint mode.
void paintCells(EditContext& context, ShapeHandle shape, std::span<const BrickSubset> cells, const Paint& paint);

}  // namespace rubble
