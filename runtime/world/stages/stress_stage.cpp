#include <algorithm>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/destruction/crack_cells.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {

/// What the last step found too weak opens now, like any other cut.
void EditStep::openCracks() {
    for (const ShapeHandle handle : m_world.m_stress->busy()) {
        WorldStress::Entry& entry = *m_world.m_stress->find(handle);
        for (const StressCrack& crack : std::exchange(entry.cracks, {}))
            if (m_world.m_shapes.find(handle)) openCrack(handle, entry.entries, crack);
    }
}

void EditStep::openCrack(ShapeHandle handle, const StrengthTable& entries, const StressCrack& crack) {
    Shape& shape = m_world.m_shapes.at(handle);
    const Densities densities(*shape.palette, m_world.m_materials);
    CarveResult carved;
    for (const BrickSubset& subset : crackCells(shape.grid, shape.anchors, entries, crack.section))
        removeCells(shape.grid, subset, densities, carved);
    if (carved.voxels == 0) return;
    glm::dvec3 normal(0.0);
    normal[crack.section.axis] = 1.0;
    const Pose pose = m_world.shapeToWorld(handle);
    const glm::dvec3 center = pose.transformPoint(sectionShape(crack.section).centroid * double(shape.voxelSize));
    const size_t mainEntry =
        size_t(std::max_element(carved.removed.begin(), carved.removed.end()) - carved.removed.begin());
    m_changes.cracks.push_back(
        {handle, center, pose.rotation * normal, (*shape.palette)[mainEntry].material, crack.cause, carved.voxels});
    recordCarved(handle, carved);
}

/// Tells the analyses what changed and lets them work.
void EditStep::runStressAnalysis() {
    WorldStress& stress = *m_world.m_stress;
    for (const ShapeHandle handle : m_changes.shapesDestroyed) stress.remove(handle);
    for (const ShapeHandle handle : m_changes.unanchored) stress.remove(handle);
    for (const ShapeHandle handle : m_changes.shapesCreated)
        if (m_world.m_shapes.find(handle)) m_world.addStress(handle);
    for (const auto& [slot, each] : m_editStates)
        if (WorldStress::Entry* entry = stress.find(each.shape); entry && !each.carved.empty()) {
            std::vector<glm::ivec3> bricks;
            each.carved.forEach([&](glm::ivec3 brick) { bricks.push_back(brick); });
            entry->analysis.markChanged(bricks);
            stress.wake(each.shape);
        }
    int64_t work = m_world.m_settings.stress.workPerStep;
    for (const ShapeHandle handle : stress.busy()) {
        if (work <= 0) break;
        runShapeAnalysis(*stress.find(handle), work);
        stress.served(handle);
    }
}

/// Told of by steps of a sixteenth, so that a fire does not have a shape weighed for every spark.
void EditStep::weaken(ShapeHandle handle, glm::ivec3 brick, int left) {
    WorldStress::Entry* entry = m_world.m_stress->find(handle);
    if (!entry) return;
    left = (left + 15) / 16 * 16;
    const auto place = std::lower_bound(entry->weak.begin(), entry->weak.end(), brick,
                                        [](const WeakBrick& a, glm::ivec3 b) { return cellBefore(a.brick, b); });
    const bool isKnown = place != entry->weak.end() && place->brick == brick;
    if (left == (isKnown ? place->left : 256)) return;
    if (isKnown)
        place->left = left;
    else
        entry->weak.insert(place, {brick, left});
    entry->analysis.restart();
    m_world.m_stress->wake(handle);
}

void EditStep::runShapeAnalysis(WorldStress::Entry& entry, int64_t& work) {
    const Shape& shape = m_world.m_shapes.at(entry.shape);
    if (entry.palette != shape.palette) {
        entry.palette = shape.palette;
        entry.entries = makeStrengthTable(*shape.palette, m_world.m_materials);
    }
    const StressSettings& settings = m_world.m_settings.stress;
    const glm::dvec3 gravity =
        glm::conjugate(m_world.shapeToWorld(entry.shape).rotation) * glm::dvec3(m_world.m_environment.gravity);
    const StressedShape stressed{shape.grid, shape.anchors,   entry.entries,
                                 gravity,    shape.voxelSize, settings.strengthScale * shape.strength,
                                 entry.weak};
    entry.analysis.run(stressed, work, settings.cracksPerStep, entry.cracks);
    if (!entry.analysis.isIdle()) return;
    if (!entry.analysis.hasConverged())
        logWarning("stress: the forces in a shape could not be found; it bears whatever comes");
    if (entry.cracks.empty()) m_world.m_stress->sleep(entry.shape);
}

}  // namespace rubble
