#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <optional>

#include "runtime/core/log.h"
#include "runtime/core/random.h"
#include "runtime/destruction/free_body_fracture.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {
namespace {

constexpr int kMaxSearchCells =
    8;  ///< cells from the place of a impact to what takes it: what was there may just have been crushed
constexpr double kMaxMagnitude = 1e12;  ///< metres, N s

bool isSane(glm::dvec3 v) {
    return glm::dot(v, v) < kMaxMagnitude * kMaxMagnitude;  // false for what is no number
}

/// The voxel nearest to a point in cells.
std::optional<glm::ivec3> cellAt(const VoxelGrid& grid, glm::dvec3 pointCells) {
    const glm::ivec3 middle(glm::floor(glm::clamp(pointCells, -1e6, 1e6)));
    for (int radius = 1; radius <= kMaxSearchCells; radius *= 2) {
        double nearest2 = std::numeric_limits<double>::infinity();
        std::optional<glm::ivec3> found;
        for (int z = -radius; z <= radius; ++z)
            for (int y = -radius; y <= radius; ++y)
                for (int x = -radius; x <= radius; ++x) {
                    const glm::ivec3 cell = middle + glm::ivec3(x, y, z);
                    const glm::dvec3 offset = glm::dvec3(cell) + 0.5 - pointCells;
                    if (!(glm::dot(offset, offset) < nearest2) || !grid.at(cell)) continue;
                    nearest2 = glm::dot(offset, offset);
                    found = cell;
                }
        if (found) return found;
    }
    return {};
}

}  // namespace

void EditStep::apply(const ImpactLoadEdit& edit) {
    const Shape* shape = m_world.m_shapes.find(edit.shape);
    if (!shape) return logWarning("ImpactLoadEdit: the handle of its shape is stale; nothing was struck");
    if (!isSane(edit.position) || !isSane(edit.impulse))
        return logWarning("ImpactLoadEdit: expected numbers below 1e12; nothing was struck");
    const StressSettings& settings = m_world.m_settings.stress;
    if (!m_world.m_stress || !shape->loadBearing || !(settings.contactTime > 0.0)) return;
    const Pose pose = m_world.shapeToWorld(edit.shape);
    const std::optional<glm::ivec3> cell =
        cellAt(shape->grid, pose.inversePoint(edit.position) / double(shape->voxelSize));
    if (!cell) return;
    const ImpactForce impact{*cell, glm::conjugate(pose.rotation) * edit.impulse / settings.contactTime};
    if (!m_world.m_bodies.at(shape->body).isStatic) return fracturePiece(edit.shape, impact);
    WorldStress::Entry* entry = m_world.m_stress->find(edit.shape);
    if (!entry) return;
    // The scale of strengths stands for more weight, not for weaker materials: a impact is measured against what they
    // are.
    entry->analysis.applyImpact({impact.cell, impact.force * settings.strengthScale});
    m_world.m_stress->wake(edit.shape);
}

/// A piece breaks at once: how it takes up the impact depends on nothing but itself.
void EditStep::fracturePiece(ShapeHandle handle, const ImpactForce& impact) {
    const Shape& shape = m_world.m_shapes.at(handle);
    const StressSettings& settings = m_world.m_settings.stress;
    if (shape.grid.voxelCount() < settings.minStruckVoxels || shape.grid.brickCount() > settings.largestShape) return;
    if (m_world.m_bodies.at(shape.body).shapes.size() != 1 || !m_impactLoaded.insert(handle.slot()).second) return;
    const StrengthTable entries = makeStrengthTable(*shape.palette, m_world.m_materials);
    const StressedShape body{shape.grid, {}, entries, glm::dvec3(0.0), shape.voxelSize, shape.strength};
    const uint32_t seed = hashCell(int(m_changes.step), int(handle.slot()), 0);
    const std::vector<FracturePlane> planes = findFracturePlanes(body, impact, seed);
    if (planes.empty()) return;
    recordMotion(shape.body);
    for (const FracturePlane& plane : planes)
        for (const Section& section : sectionsInPlane(shape.grid, entries, plane.axis, plane.plane))
            openCrack(handle, entries, {section, plane.utilization, plane.cause});
}

}  // namespace rubble
