#include "runtime/world/stages/carve_edits.h"

#include <algorithm>

#include "runtime/world/edits/resolve_brush.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/queries/query.h"
#include "runtime/world/stages/paint_edits.h"
#include "runtime/world/stages/rope_stage.h"

namespace rubble {
namespace {

constexpr std::array<uint8_t, 3> kSootColor = {24, 21, 18};
constexpr double kSootRadius = 1.45;  ///< of an explosion's soot, as a multiple of its size

void carveShape(EditContext& context, ShapeHandle handle, const CarveEdit& edit) {
    Shape& shape = context.world.shapes.at(handle);
    const Brush brush = resolveBrush(edit, shapeToWorld(context.world, handle), shape.voxelSize);
    if (brushBricks(brush, shape.grid.sizeInBricks()).empty()) return;
    context.recordMotion(shape.body);
    CarveResult carved;
    carve(shape.grid, brush, *shape.palette, context.world.materials, carved, edit.tool);
    if (carved.voxels) context.recordCarved(handle, carved);
}

/// A light group loses what breaks off as if it were removed.
void countLightVoxels(EditContext& context, const VoxelGrid& grid, const Palette& palette) {
    if (context.removedByGroup.empty()) return;
    grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int i) {
            const uint32_t group = palette[brick->at(i)].lightGroup;
            if (group && group <= context.removedByGroup.size()) ++context.removedByGroup[group - 1];
        });
    });
}

void breakShape(EditContext& context, ShapeHandle handle, const BreakEdit& edit) {
    Shape& shape = context.world.shapes.at(handle);
    const CarveEdit sphere{.position = edit.position, .radii = edit.radii};
    const Brush brush = resolveBrush(sphere, shapeToWorld(context.world, handle), shape.voxelSize);
    if (brushBricks(brush, shape.grid.sizeInBricks()).empty()) return;
    context.recordMotion(shape.body);
    const WorldSettings& settings = context.world.settings;
    FracturePlan plan{.tool = edit.tool, .seed = edit.seed};
    plan.unitsPerMetre = std::max<int64_t>(int64_t(double(kBrushUnit) / double(shape.voxelSize) + 0.5), 1);
    plan.maxFragments = settings.debris.fragmentsPerBreak;
    plan.minVoxels = settings.minPieceVoxels;
    FractureResult broken = fracture(shape.grid, brush, *shape.palette, context.world.materials, plan);
    if (broken.dust.bricks.empty()) return;
    context.recordCarved(handle, broken.dust);
    for (Fragment& fragment : broken.fragments) {
        shape.moments -= fragment.moments;
        countLightVoxels(context, fragment.piece.grid, *shape.palette);
        context.editState(handle).fragments.push_back({std::move(fragment), shape.palette, shape.paintColors});
    }
}

}  // namespace

void apply(EditContext& context, const CarveEdit& edit) {
    if (!edit.shape) {
        cutRopes(context, edit);
        const BoundingSphere bounds = boundingSphere(edit);
        for (const ShapeHandle handle : shapesNear(context.world, bounds.center, bounds.radius))
            carveShape(context, handle, edit);
        return;
    }
    if (context.world.shapes.find(edit.shape))
        carveShape(context, edit.shape, edit);
    else
        context.warnStale(edit.shape, "carve: the handle of its shape is stale; nothing was carved");
}

uint64_t countCarved(const WorldData& world, const CarveEdit& edit) {
    uint64_t voxels = 0;
    const auto count = [&](ShapeHandle handle) {
        const Shape& shape = world.shapes.at(handle);
        const Brush brush = resolveBrush(edit, shapeToWorld(world, handle), shape.voxelSize);
        voxels += countCarved(shape.grid, brush, *shape.palette, world.materials, edit.tool);
    };
    if (edit.shape) {
        if (world.shapes.find(edit.shape)) count(edit.shape);
        return voxels;
    }
    const BoundingSphere bounds = boundingSphere(edit);
    for (const ShapeHandle handle : shapesNear(world, bounds.center, bounds.radius)) count(handle);
    return voxels;
}

void apply(EditContext& context, const BreakEdit& edit) {
    if (!edit.shape) {
        cutRopes(context, {.position = edit.position, .radii = edit.radii});
        for (const ShapeHandle handle : shapesNear(context.world, edit.position, edit.radii[0]))
            breakShape(context, handle, edit);
        return;
    }
    if (context.world.shapes.find(edit.shape))
        breakShape(context, edit.shape, edit);
    else
        context.warnStale(edit.shape, "break_voxels: the handle of its shape is stale; nothing was broken");
}

void apply(EditContext& context, const ExplodeEdit& edit) {
    const uint32_t seed = uint32_t(context.changes.step);
    apply(context, BreakEdit{.position = edit.position,
                             .radii = {edit.size, 0.7 * edit.size, 0.4 * edit.size},
                             .tool = Tool::Explosive,
                             .seed = seed});
    context.changes.blasts.push_back({edit.position, edit.size});
    apply(context, PaintEdit{.position = edit.position,
                             .radius = kSootRadius * edit.size,
                             .color = kSootColor,
                             .strength = 190,
                             .probability = 20,
                             .seed = seed});
    context.impulses.emplace_back(edit);
}

}  // namespace rubble
