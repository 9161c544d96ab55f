#include "runtime/core/log.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {

void EditStep::apply(const BreakEdit& edit) {
    if (!edit.shape) {
        cutRopes({.position = edit.position, .radii = edit.radii});
        for (const ShapeHandle handle : m_world.shapesNear(edit.position, edit.radii[0])) breakShape(handle, edit);
        return;
    }
    if (m_world.m_shapes.find(edit.shape))
        breakShape(edit.shape, edit);
    else
        logWarning("BreakEdit: the handle of its shape is stale; nothing was broken");
}

void EditStep::breakShape(ShapeHandle handle, const BreakEdit& edit) {
    Shape& shape = m_world.m_shapes.at(handle);
    const CarveEdit sphere{.position = edit.position, .radii = edit.radii};
    const Brush brush = resolveBrush(sphere, m_world.shapeToWorld(handle), shape.voxelSize);
    if (brushBricks(brush, shape.grid.sizeInBricks()).empty()) return;
    recordMotion(shape.body);
    const WorldSettings& settings = m_world.m_settings;
    FracturePlan plan{.tool = edit.tool, .seed = edit.seed};
    plan.unitsPerMetre = std::max<int64_t>(int64_t(double(kBrushUnit) / double(shape.voxelSize) + 0.5), 1);
    plan.maxFragments = settings.debris.fragmentsPerBreak;
    plan.minVoxels = settings.minPieceVoxels;
    FractureResult broken = fracture(shape.grid, brush, *shape.palette, m_world.m_materials, plan);
    if (broken.dust.bricks.empty()) return;
    recordCarved(handle, broken.dust);
    for (Fragment& fragment : broken.fragments) {
        shape.moments -= fragment.moments;
        countLightVoxels(fragment.piece.grid, *shape.palette);
        editState(handle).fragments.push_back({std::move(fragment), shape.palette, shape.paintColors});
    }
}

/// To a light group, what breaks off is as good as gone.
void EditStep::countLightVoxels(const VoxelGrid& grid, const Palette& palette) {
    if (m_removedByGroup.empty()) return;
    grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int i) {
            const uint32_t group = palette[brick->at(i)].lightGroup;
            if (group && group <= m_removedByGroup.size()) ++m_removedByGroup[group - 1];
        });
    });
}

void EditStep::apply(const ExplodeEdit& edit) {
    const uint32_t seed = uint32_t(m_changes.step);
    apply(BreakEdit{edit.position, {edit.size, 0.7 * edit.size, 0.4 * edit.size}, Tool::Explosive, seed, {}});
    m_changes.blasts.push_back({edit.position, edit.size});
    constexpr std::array<uint8_t, 3> kSoot = {24, 21, 18};
    apply(PaintEdit{edit.position, 1.45 * edit.size, kSoot, 190, 20, seed});
    m_deferredImpulses.emplace_back(edit);
}

}  // namespace rubble
