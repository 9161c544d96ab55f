#include "runtime/world/stages/create_edits.h"

#include <algorithm>
#include <string>
#include <utility>

#include "runtime/voxel/make_grid.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/stages/entry_counts.h"
#include "runtime/world/stages/light_group_stage.h"
#include "runtime/world/stages/palette_edits.h"
#include "runtime/world/stages/shape_lifecycle.h"
#include "runtime/world/state/load_level.h"

namespace rubble {
namespace {

/// A copy of `from` that is placed and named as the edit says.
Shape copyShape(const WorldData& world, const Shape& from, const CreateShapeEdit& edit, const Body& body) {
    Shape out = from;
    if (!edit.shape.name.empty()) out.name = edit.shape.name;
    if (edit.shape.voxelSize > 0.0f) out.voxelSize = edit.shape.voxelSize;
    out.local = edit.shape.local;
    out.isPiece = out.broken = false;
    if (!body.isStatic) out.anchors.clear();
    if (!world.bodies.at(from.body).isStatic) anchorByDefault(out, body);
    return out;
}

Shape makeNew(const WorldData& world, const CreateShapeEdit& edit, const Body& body) {
    LevelShape from = edit.shape;
    if (edit.source == ShapeSource::Box) from.grid = solidBox(edit.size, edit.entry);
    if (edit.source == ShapeSource::Sphere) from.grid = solidEllipsoid(edit.size, edit.entry);
    if (!from.palette) from.palette = materialPalette(world.materials);
    return makeShape(from, body, world.materials);
}

}  // namespace

void apply(EditContext& context, const CreateBodyEdit& edit) {
    Body body = edit.body;
    body.shapes.clear();
    body.waitsToWake = body.settled = body.broken = false;
    body.createdStep = context.changes.step;
    body.restingSince = body.asleep ? context.changes.step : 0;
    if (body.isStatic) body.velocity = body.angularVelocity = glm::dvec3(0.0), body.asleep = false;
    context.changes.bodiesCreated.push_back(context.make(context.world.bodies, std::move(body)));
}

void apply(EditContext& context, const CreateShapeEdit& edit) {
    const Body* body = context.world.bodies.find(edit.body);
    if (!body) return context.refuse("the handle of its body is stale");
    const bool isCopy = edit.source == ShapeSource::Copy;
    const Shape* copied = isCopy ? context.world.shapes.find(edit.copied) : nullptr;
    if (isCopy && !copied) return context.refuse("the handle of the shape to copy is stale");
    const Shape* painted = edit.paletteOf ? context.world.shapes.find(edit.paletteOf) : nullptr;
    if (edit.paletteOf && !painted) return context.refuse("the handle of the shape with its palette is stale");
    const PaletteRef& palette = painted ? painted->palette : isCopy ? copied->palette : edit.shape.palette;
    if (const std::string error = palette ? paletteError(context.world, std::span(*palette).subspan(1)) : "";
        !error.empty())
        return context.refuse(error);
    Shape shape = isCopy ? copyShape(context.world, *copied, edit, *body) : makeNew(context.world, edit, *body);
    if (painted) {
        shape.palette = painted->palette;
        shape.moments = gridMoments(shape.grid, *shape.palette, context.world.materials);
    }
    if (!context.isNew(edit.body)) context.recordMotion(edit.body);
    shape.body = edit.body;
    context.world.imported += shape.grid.voxelCount();
    if (context.world.groups.size() > 0) countMade(context, *shape.palette, countEntries(shape.grid));
    const bool isEmpty = shape.grid.empty();
    const ShapeHandle handle = context.make(context.world.shapes, std::move(shape));
    context.world.bodies.at(edit.body).shapes.push_back(handle);
    context.world.updateShapeBounds(handle);
    context.changes.shapesCreated.push_back(handle);
    context.placedShapes.push_back(handle);
    if (isEmpty)  // it may be refused in the end: what writes its voxels wakes the body
        context.emptyShapes.push_back(handle);
    else if (!context.isNew(edit.body))
        context.wakeBody(edit.body);
    context.world.updateDebris(edit.body);
}

void settlePlacedShapes(EditContext& context) {
    for (const ShapeHandle handle : context.emptyShapes) {
        const Shape* shape = context.world.shapes.find(handle);
        if (!shape || !shape->grid.empty() || context.editState(handle).lostVoxels) continue;
        eraseEmptyShape(context, handle);
        context.refuse(AnyHandle{handle.bits}, "create_shape", "the shape has no voxels: write some before the step");
    }
    for (const ShapeHandle handle : context.placedShapes)
        if (context.world.shapes.find(handle)) includeMade(context.world, handle);
}

}  // namespace rubble
