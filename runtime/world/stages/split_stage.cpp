#include "runtime/world/stages/split_stage.h"

#include <algorithm>

#include "runtime/destruction/detachment.h"
#include "runtime/destruction/local_connectivity.h"
#include "runtime/destruction/split.h"
#include "runtime/world/stages/heat_moves.h"
#include "runtime/world/stages/joint_stage.h"
#include "runtime/world/stages/light_stage.h"
#include "runtime/world/stages/shape_lifecycle.h"

namespace rubble {
namespace {

/// Whether the surroundings of a cut alone show that the shape is still connected.
bool isStillConnected(const EditContext& context, const ShapeEditState& each) {
    const Shape* shape = context.world.shapes.find(each.shape);
    if (!shape || !shape->knownConnected || each.lostVoxels || shape->grid.empty()) return false;
    const bool isAnchored = context.world.bodies.at(shape->body).isStatic;
    if (!isAnchored && shape->grid.voxelCount() < context.world.settings.minPieceVoxels) return false;
    return isLocallyConnected(shape->grid, each.lost,
                              isAnchored ? std::span<const CellBox>(shape->anchors) : std::span<const CellBox>());
}

void splitShape(EditContext& context, ShapeHandle parent, const Detached& detached) {
    const uint64_t smallest = context.world.settings.minPieceVoxels;
    Shape* shape = &context.world.shapes.at(parent);
    const bool isAnchored = context.world.bodies.at(shape->body).isStatic;
    const Densities densities(*shape->palette, context.world.materials);
    ShapeSplit split{.parent = parent};
    for (const Component& component : detached.pieces) {
        const MassMoments moments = componentMoments(shape->grid, component, densities);
        if (moments.weight == 0) continue;  // unphysical voxels do not collide: they stay where they are
        context.editState(parent).carved.insert(component);
        shape->moments -= moments;
        if (component.voxels < smallest) {
            discardPiece(context, parent, component);
            continue;
        }
        Piece piece = takePiece(shape->grid, component);
        split.parentOffset.push_back(piece.offset);
        split.children.push_back(createPiece(context, parent, std::move(piece), moments, split.motions.emplace_back()));
        shape = &context.world.shapes.at(parent);  // inserting a shape may have moved the others
    }
    const bool isFree = detached.isUnanchored || !isAnchored;
    if (isFree && shape->grid.voxelCount() < smallest)
        for (const Component& rest : findComponents(shape->grid)) {
            context.editState(parent).carved.insert(rest);
            shape->moments -= componentMoments(shape->grid, rest, densities);
            discardPiece(context, parent, rest);
        }
    if (!split.children.empty()) {
        context.cutWires.insert(parent.slot());
        moveLights(context, split);
        moveJoints(context, split);
        moveHeat(context, split);
    }
    if (shape->grid.empty())
        destroyShape(context, parent);
    else if (detached.isUnanchored && shape->moments.weight > 0)
        detachToNewBody(context, parent);
    if (!split.children.empty()) context.changes.splits.push_back(std::move(split));
}

/// Goes on with the connectivity test of a shape. True if nothing is left to do for it: it was split, or is gone.
bool continueSearch(EditContext& context, PendingSplit& pending, size_t& budget) {
    Shape* shape = context.world.shapes.find(pending.shape);
    if (!shape) return true;
    if (budget == 0) return false;
    const bool isAnchored = context.world.bodies.at(shape->body).isStatic;
    if (!shape->knownConnected) {  // a shape's first test looks at all of it, at once
        context.recordMotion(shape->body);
        shape->knownConnected = true;
        budget -= std::min(budget, shape->grid.brickCount() / 64 + 1);  // about its nodes, of 64 bricks each
        splitShape(context, pending.shape, findDetached(shape->grid, shape->anchors, isAnchored));
        return true;
    }
    if (!pending.search) pending.search.emplace(shape->grid, shape->anchors, isAnchored, pending.cut);
    if (!pending.search->run(shape->grid, shape->anchors, budget)) {
        budget = 0;
        return false;
    }
    context.recordMotion(shape->body);
    splitShape(context, pending.shape, detachedFrom(*pending.search, shape->grid, isAnchored));
    return true;
}

}  // namespace

void releaseFragments(EditContext& context) {
    for (auto& [slot, broken] : context.editStates) {
        if (broken.fragments.empty()) continue;
        ShapeSplit split{.parent = broken.shape};
        for (auto& [fragment, palette, paintColors] : broken.fragments) {
            split.parentOffset.push_back(fragment.piece.offset);
            split.children.push_back(createPiece(context, broken.shape, std::move(fragment.piece), fragment.moments,
                                                 split.motions.emplace_back()));
            Shape& child = context.world.shapes.at(split.children.back());
            child.palette = std::move(palette);
            child.paintColors = std::move(paintColors);
        }
        broken.fragments.clear();
        context.cutWires.insert(broken.shape.slot());
        moveLights(context, split);
        moveJoints(context, split);
        moveHeat(context, split);
        context.changes.splits.push_back(std::move(split));
    }
}

void dropEmptyShapes(EditContext& context) {
    std::vector<ShapeHandle> empty;
    for (const auto& [slot, each] : context.editStates)
        if (const Shape* shape = context.world.shapes.find(each.shape); shape && shape->grid.empty())
            empty.push_back(each.shape);
    for (const ShapeHandle shape : empty) destroyShape(context, shape);
}

void splitShapes(EditContext& context) {
    releaseFragments(context);
    std::vector<PendingSplit>& line = context.world.pendingSplits;
    for (auto& [slot, each] : context.editStates) {
        if (each.carved.empty() && !each.lostVoxels) continue;
        auto known = std::find_if(line.begin(), line.end(),
                                  [shape = each.shape](const PendingSplit& pending) { return pending.shape == shape; });
        if (known == line.end() && isStillConnected(context, each)) continue;
        if (known == line.end()) known = line.insert(line.end(), {each.shape, {}, {}});
        known->cut.insert(each.carved);
        known->search.reset();
    }
    size_t budget = context.world.settings.split.partsPerStep;
    if (budget == 0) budget = SIZE_MAX;
    size_t done = 0;
    while (done < line.size() && continueSearch(context, line[done], budget)) ++done;
    line.erase(line.begin(), line.begin() + ptrdiff_t(done));
    std::erase_if(line, [&](const PendingSplit& pending) {  // what has no voxel left does not wait
        const Shape* shape = context.world.shapes.find(pending.shape);
        const bool isEmpty = shape && shape->grid.empty();
        if (isEmpty) destroyShape(context, pending.shape);
        return isEmpty;
    });
}

}  // namespace rubble
