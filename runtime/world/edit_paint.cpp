#include <algorithm>

#include "runtime/destruction/paint.h"
#include "runtime/world/edit_step.h"

namespace rubble {

void EditStep::apply(const PaintEdit& edit) {
    CarveEdit sphere{.position = edit.position};
    sphere.radii.fill(edit.radius);
    for (const ShapeHandle handle : m_world.shapesNear(edit.position, edit.radius)) paintShape(handle, edit, sphere);
}

void EditStep::paintShape(ShapeHandle handle, const PaintEdit& edit, const CarveEdit& sphere) {
    Shape& shape = m_world.m_shapes.at(handle);
    const Brush brush = resolveBrush(sphere, m_world.shapeToWorld(handle), shape.voxelSize);
    if (brushBricks(brush, shape.grid.sizeInBricks()).empty()) return;
    const Painted painted = paint(shape.grid, shape.palette, brush, {edit.color, edit.strength, edit.probability, edit.seed});
    m_changes.paintedVoxels += painted.voxels;
    m_changes.paintMerges += painted.merges;
    if (painted.palette) {
        shape.palette = painted.palette;
        std::vector<ShapeHandle>& palettes = m_changes.palettes;
        if (std::find(palettes.begin(), palettes.end(), handle) == palettes.end()) palettes.push_back(handle);
    }
    if (painted.bricks.empty()) return;
    std::vector<glm::ivec3>& bricks = touched(handle).painted;
    bricks.insert(bricks.end(), painted.bricks.begin(), painted.bricks.end());
}

}  // namespace rubble
