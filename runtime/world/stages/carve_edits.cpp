#include <cmath>

#include "runtime/core/log.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {

void EditStep::apply(const CarveEdit& edit) {
    if (!edit.shape) {
        cutRopes(edit);
        const BoundingSphere bounds = boundingSphere(edit);
        for (const ShapeHandle handle : m_world.shapesNear(bounds.center, bounds.radius)) carveShape(handle, edit);
        return;
    }
    if (m_world.m_shapes.find(edit.shape))
        carveShape(edit.shape, edit);
    else
        logWarning("CarveEdit: the handle of its shape is stale; nothing was carved");
}

void EditStep::carveShape(ShapeHandle handle, const CarveEdit& edit) {
    Shape& shape = m_world.m_shapes.at(handle);
    const Brush brush = resolveBrush(edit, m_world.shapeToWorld(handle), shape.voxelSize);
    if (brushBricks(brush, shape.grid.sizeInBricks()).empty()) return;
    recordMotion(shape.body);
    CarveResult carved;
    carve(shape.grid, brush, *shape.palette, m_world.m_materials, carved, edit.tool);
    if (carved.voxels) recordCarved(handle, carved);
}

void EditStep::recordCarved(ShapeHandle handle, const CarveResult& carved) {
    Shape& shape = m_world.m_shapes.at(handle);
    shape.moments -= carved.moments;
    recordRemoved(handle, carved);
    ShapeEditState& each = editState(handle);
    each.lost = joined(each.lost, carved.cells);
    for (const glm::ivec3 brick : carved.bricks) each.carved.insert(brick);
}

void EditStep::recordRemoved(ShapeHandle handle, const CarveResult& carved) {
    if (carved.voxels == 0) return;
    const Shape& shape = m_world.m_shapes.at(handle);
    const glm::dvec3 center =
        m_world.shapeToWorld(handle).transformPoint(massProperties(carved.moments, shape.voxelSize).center);
    const double radius = 0.5 * shape.voxelSize * std::cbrt(double(carved.voxels));
    recordRemoved(handle, carved.removed, {center, radius, m_world.m_bodies.at(shape.body).velocity});
}

void EditStep::recordRemoved(ShapeHandle handle, const std::array<uint64_t, 256>& removed, const DustSource& place) {
    const Palette& palette = *m_world.m_shapes.at(handle).palette;
    for (size_t i = 1; i < 256; ++i) {
        if (!removed[i]) continue;
        const PaletteEntry& entry = palette[i];
        m_changes.removed.push_back(
            {handle, uint8_t(i), entry.material, {entry.red, entry.green, entry.blue}, removed[i]});
        m_changes.dust.push_back({place.position,
                                  place.radius,
                                  place.velocity,
                                  {entry.red, entry.green, entry.blue},
                                  entry.material,
                                  removed[i]});
        m_world.m_removed += removed[i];
        if (entry.material && entry.material == m_world.m_wire) m_cutWires.insert(handle.slot());
        if (entry.lightGroup && entry.lightGroup <= m_removedByGroup.size())
            m_removedByGroup[entry.lightGroup - 1] += removed[i];
    }
}

}  // namespace rubble
