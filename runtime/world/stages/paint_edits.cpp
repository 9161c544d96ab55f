#include <algorithm>
#include <cmath>

#include "runtime/core/log.h"
#include "runtime/destruction/paint.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {

void EditStep::apply(const PaintEdit& edit) {
    CarveEdit area{.kind = edit.kind == BrushKind::Capsule ? BrushKind::Capsule : BrushKind::Sphere,
                   .position = edit.position,
                   .end = edit.end};
    area.radii.fill(edit.radius);
    const BoundingSphere bounds = boundingSphere(area);
    if (!(bounds.radius >= 0.0) || !std::isfinite(bounds.radius))
        return logWarning("PaintEdit: a position or radius is not a number; nothing was painted");
    if (edit.shape) {
        if (!m_world.m_shapes.find(edit.shape))
            return logWarning("PaintEdit: the handle of its shape is stale; nothing was painted");
        return paintShape(edit.shape, edit, area);
    }
    for (const ShapeHandle handle : m_world.shapesNear(bounds.center, bounds.radius)) paintShape(handle, edit, area);
}

void EditStep::paintShape(ShapeHandle handle, const PaintEdit& edit, const CarveEdit& area) {
    Shape& shape = m_world.m_shapes.at(handle);
    const Brush brush = resolveBrush(area, m_world.shapeToWorld(handle), shape.voxelSize);
    if (brushBricks(brush, shape.grid.sizeInBricks()).empty()) return;
    const Paint paint{edit.color, edit.strength, edit.probability, edit.seed, edit.falloff};
    const PaintMode mode = edit.mode == PaintMode::Default ? m_world.m_settings.paint.mode : edit.mode;
    commitPaint(handle, mode == PaintMode::Layer ? paintLayer(shape.grid, shape.paintColors, brush, paint)
                                                 : paintPalette(shape.grid, shape.palette, brush, paint));
}

void EditStep::paintCells(ShapeHandle handle, std::span<const BrickSubset> cells, const Paint& paint) {
    Shape& shape = m_world.m_shapes.at(handle);
    commitPaint(handle, m_world.m_settings.paint.mode == PaintMode::Layer
                            ? paintLayer(shape.grid, shape.paintColors, cells, paint)
                            : paintPalette(shape.grid, shape.palette, cells, paint));
}

/// Takes over what painting has changed besides the bricks, and into the journal.
void EditStep::commitPaint(ShapeHandle handle, const PaintResult& painted) {
    Shape& shape = m_world.m_shapes.at(handle);
    m_changes.paintedVoxels += painted.voxels;
    m_changes.paintMerges += painted.merges;
    if (painted.palette) shape.palette = painted.palette;
    if (painted.colors) shape.paintColors = painted.colors;
    std::vector<ShapeHandle>& palettes = m_changes.palettes;
    if ((painted.palette || painted.colors) && std::find(palettes.begin(), palettes.end(), handle) == palettes.end())
        palettes.push_back(handle);
    if (painted.bricks.empty()) return;
    BrickSet& bricks = editState(handle).painted;
    for (const glm::ivec3 brick : painted.bricks) bricks.insert(brick);
}

}  // namespace rubble
