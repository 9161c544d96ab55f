#include "runtime/world/stages/impact_load_stage.h"

#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "runtime/core/random.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/nearest_voxel.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/stages/stress_stage.h"

namespace rubble {
namespace {

constexpr int kMaxSearchCells = 8;  ///< around an impact, whose own voxels may just have been removed

/// The voxel nearest to a point, both in cells, in ever larger cubes around it.
std::optional<glm::ivec3> findStruckCell(const VoxelGrid& grid, glm::dvec3 point) {
    const glm::ivec3 middle = cellAt(point);
    for (int radius = 1; radius <= kMaxSearchCells; radius *= 2)
        if (const auto cell = nearestVoxel(grid, point, {middle - radius, middle + radius + 1})) return cell;
    return {};
}

}  // namespace

void ImpactLoadStage::apply(const ImpactLoadEdit& edit) {
    const Shape* shape = m_context.world.shapes.find(edit.shape);
    if (!shape)
        return m_context.warnStale(edit.shape, "impact load: the handle of its shape is stale; nothing was struck");
    const StressSettings& settings = m_context.world.settings.stress;
    if (!m_context.world.stress || !shape->loadBearing || !(settings.contactTime > 0.0)) return;
    const Pose pose = shapeToWorld(m_context.world, edit.shape);
    const std::optional<glm::ivec3> cell =
        findStruckCell(shape->grid, pose.inversePoint(edit.position) / double(shape->voxelSize));
    if (!cell) return;
    const ImpactForce impact{*cell, glm::conjugate(pose.rotation) * edit.impulse / settings.contactTime};
    if (!m_context.world.bodies.at(shape->body).isStatic) return fracturePiece(edit.shape, impact);
    WorldStress::Entry* entry = m_context.world.stress->find(edit.shape);
    if (!entry) return;
    // strengthScale stands for more weight, not for weaker materials: impacts meet the materials' own strength.
    entry->analysis.applyImpact({impact.cell, impact.force * settings.strengthScale});
    m_context.world.stress->wake(edit.shape);
}

/// A piece breaks at once: how inertia balances the impact depends on nothing but the piece.
void ImpactLoadStage::fracturePiece(ShapeHandle handle, const ImpactForce& impact) {
    const Shape& shape = m_context.world.shapes.at(handle);
    const StressSettings& settings = m_context.world.settings.stress;
    if (shape.grid.voxelCount() < settings.minStruckVoxels || shape.grid.brickCount() > settings.largestShape) return;
    if (m_context.world.bodies.at(shape.body).shapes.size() != 1 || !m_tested.insert(handle.slot()).second) return;
    const StrengthTable entries = makeStrengthTable(*shape.palette, m_context.world.materials);
    const StressedShape body{shape.grid, {}, entries, glm::dvec3(0.0), shape.voxelSize, shape.strength};
    const uint32_t seed = hashCell(int(m_context.changes.step), int(handle.slot()), 0);
    const std::vector<FracturePlane> planes = findFracturePlanes(body, impact, seed);
    if (planes.empty()) return;
    m_context.recordMotion(shape.body);
    for (const FracturePlane& plane : planes)
        for (const Section& section : sectionsInPlane(shape.grid, entries, plane.axis, plane.plane))
            openCrack(m_context, handle, entries, {section, plane.utilization, plane.cause});
}

}  // namespace rubble
