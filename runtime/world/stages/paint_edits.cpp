#include "runtime/world/stages/paint_edits.h"

#include <cmath>

#include "runtime/core/log.h"
#include "runtime/world/edits/resolve_brush.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/queries/query.h"

namespace rubble {
namespace {

/// Takes over what painting changed besides the bricks, and adds it to the journal.
void commitPaint(EditContext& context, ShapeHandle handle, const PaintResult& painted) {
    Shape& shape = context.world.shapes.at(handle);
    context.changes.paintedVoxels += painted.voxels;
    context.changes.paintMerges += painted.merges;
    if (painted.palette) shape.palette = painted.palette;
    if (painted.colors) shape.paintColors = painted.colors;
    if (painted.palette || painted.colors) context.listPalette(handle);
    if (painted.bricks.empty()) return;
    BrickSet& bricks = context.editState(handle).painted;
    for (const glm::ivec3 brick : painted.bricks) bricks.insert(brick);
}

void paintShape(EditContext& context, ShapeHandle handle, const PaintEdit& edit, const CarveEdit& area) {
    Shape& shape = context.world.shapes.at(handle);
    const Brush brush = resolveBrush(area, shapeToWorld(context.world, handle), shape.voxelSize);
    if (brushBricks(brush, shape.grid.sizeInBricks()).empty()) return;
    const Paint paint{edit.color, edit.strength, edit.probability, edit.seed, edit.falloff};
    const PaintMode mode = edit.mode == PaintMode::Default ? context.world.settings.paint.mode : edit.mode;
    commitPaint(context, handle,
                mode == PaintMode::Layer ? paintLayer(shape.grid, shape.paintColors, brush, paint)
                                         : paintPalette(shape.grid, shape.palette, brush, paint));
}

}  // namespace

void apply(EditContext& context, const PaintEdit& edit) {
    CarveEdit area{.kind = edit.kind == BrushKind::Capsule ? BrushKind::Capsule : BrushKind::Sphere,
                   .position = edit.position,
                   .end = edit.end};
    area.radii.fill(edit.radius);
    const BoundingSphere bounds = boundingSphere(area);
    if (!(bounds.radius >= 0.0) || !std::isfinite(bounds.radius))
        return logWarning("paint: a position or radius is not a number; nothing was painted");
    if (edit.shape) {
        if (!context.world.shapes.find(edit.shape))
            return context.warnStale("paint: the handle of its shape is stale; nothing was painted");
        return paintShape(context, edit.shape, edit, area);
    }
    for (const ShapeHandle handle : shapesNear(context.world, bounds.center, bounds.radius))
        paintShape(context, handle, edit, area);
}

void paintCells(EditContext& context, ShapeHandle handle, std::span<const BrickSubset> cells, const Paint& paint) {
    Shape& shape = context.world.shapes.at(handle);
    commitPaint(context, handle,
                context.world.settings.paint.mode == PaintMode::Layer
                    ? paintLayer(shape.grid, shape.paintColors, cells, paint)
                    : paintPalette(shape.grid, shape.palette, cells, paint));
}

}  // namespace rubble
