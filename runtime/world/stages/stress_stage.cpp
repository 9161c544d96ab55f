#include "runtime/world/stages/stress_stage.h"

#include <algorithm>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/destruction/crack_cells.h"
#include "runtime/world/objects/transforms.h"

namespace rubble {
namespace {

void runShapeAnalysis(EditContext& context, WorldStress::Entry& entry, int64_t& work) {
    const Shape& shape = context.world.shapes.at(entry.shape);
    if (entry.palette != shape.palette) {
        entry.palette = shape.palette;
        entry.entries = makeStrengthTable(*shape.palette, context.world.materials);
    }
    const StressSettings& settings = context.world.settings.stress;
    const glm::dvec3 gravity = glm::conjugate(shapeToWorld(context.world, entry.shape).rotation) *
                               glm::dvec3(context.world.environment.gravity);
    const StressedShape stressed{shape.grid, shape.anchors,   entry.entries,
                                 gravity,    shape.voxelSize, settings.strengthScale * shape.strength / shape.density,
                                 entry.weak};
    entry.analysis.run(stressed, work, settings.cracksPerStep, entry.cracks);
    if (!entry.analysis.isIdle()) return;
    if (!entry.analysis.hasConverged())
        logWarning("stress: the forces in shape \"" + shape.name +
                   "\" could not be found, the solver did not converge; it does not break under this load");
    if (entry.cracks.empty()) context.world.stress->sleep(entry.shape);
}

}  // namespace

void openCracks(EditContext& context) {
    for (const ShapeHandle handle : context.world.stress->busy()) {
        WorldStress::Entry& entry = *context.world.stress->find(handle);
        for (const StressCrack& crack : std::exchange(entry.cracks, {}))
            if (context.world.shapes.find(handle)) openCrack(context, handle, entry.entries, crack);
    }
}

void openCrack(EditContext& context, ShapeHandle handle, const StrengthTable& entries, const StressCrack& crack) {
    Shape& shape = context.world.shapes.at(handle);
    const Densities densities(*shape.palette, context.world.materials);
    CarveResult carved;
    for (const BrickSubset& subset : crackCells(shape.grid, shape.anchors, entries, crack.section))
        removeCells(shape.grid, subset, densities, carved);
    if (carved.voxels == 0) return;
    glm::dvec3 normal(0.0);
    normal[crack.section.axis] = 1.0;
    const Pose pose = shapeToWorld(context.world, handle);
    const glm::dvec3 center = pose.transformPoint(sectionShape(crack.section).centroid * double(shape.voxelSize));
    const size_t mainEntry =
        size_t(std::max_element(carved.removed.begin(), carved.removed.end()) - carved.removed.begin());
    context.changes.cracks.push_back(
        {handle, center, pose.rotation * normal, (*shape.palette)[mainEntry].material, crack.cause, carved.voxels});
    context.recordCarved(handle, carved);
}

void runStressAnalysis(EditContext& context) {
    WorldStress& stress = *context.world.stress;
    for (const ShapeHandle handle : context.changes.shapesDestroyed) stress.remove(handle);
    for (const ShapeHandle handle : context.changes.unanchored) stress.remove(handle);
    for (const ShapeHandle handle : context.changes.shapesCreated)
        if (context.world.shapes.find(handle)) context.world.addStress(handle);
    for (const auto& [slot, each] : context.editStates) {
        if (each.otherMaterials && stress.find(each.shape)) {  // begun again: its graph has the old weights
            stress.remove(each.shape);
            context.world.addStress(each.shape);
        }
        if (WorldStress::Entry* entry = stress.find(each.shape);
            entry && !(each.carved.empty() && each.filled.empty())) {
            std::vector<glm::ivec3> bricks;
            for (const BrickSet* set : {&each.carved, &each.filled})
                set->forEach([&](glm::ivec3 brick) { bricks.push_back(brick); });
            entry->analysis.markChanged(bricks);
            stress.wake(each.shape);
        }
    }
    int64_t work = context.world.settings.stress.workPerStep;
    for (const ShapeHandle handle : stress.busy()) {
        if (work <= 0) break;
        runShapeAnalysis(context, *stress.find(handle), work);
        stress.served(handle);
    }
}

void weakenBrick(EditContext& context, ShapeHandle handle, glm::ivec3 brick, int left) {
    WorldStress::Entry* entry = context.world.stress->find(handle);
    if (!entry) return;
    left = quantizedStrength(left);
    const auto place = std::lower_bound(entry->weak.begin(), entry->weak.end(), brick,
                                        [](const WeakBrick& a, glm::ivec3 b) { return cellBefore(a.brick, b); });
    const bool isKnown = place != entry->weak.end() && place->brick == brick;
    if (left == (isKnown ? place->left : 256)) return;
    if (isKnown)
        place->left = left;
    else
        entry->weak.insert(place, {brick, left});
    entry->analysis.restart();
    context.world.stress->wake(handle);
}

}  // namespace rubble
