#include "runtime/world/stages/shape_edits.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <string>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/world/objects/body_mass.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/stages/entry_counts.h"
#include "runtime/world/stages/heat_moves.h"
#include "runtime/world/stages/joint_stage.h"
#include "runtime/world/stages/light_group_stage.h"
#include "runtime/world/stages/light_stage.h"
#include "runtime/world/stages/palette_merge.h"
#include "runtime/world/stages/reframe_shape.h"
#include "runtime/world/stages/shape_lifecycle.h"
#include "runtime/world/stages/split_stage.h"

namespace rubble {
namespace {

/// The cell of `into` where cell 0 of `shape` lies; nothing if their cells do not line up.
std::optional<glm::ivec3> cellOffsetIn(const Shape& into, const Shape& shape) {
    if (into.body != shape.body || into.voxelSize != shape.voxelSize) return std::nullopt;
    if (std::fabs(glm::dot(into.local.rotation, shape.local.rotation)) < 1.0 - 1e-9) return std::nullopt;
    const glm::dvec3 cells = into.local.inversePoint(shape.local.position) / double(into.voxelSize);
    const glm::dvec3 whole = glm::round(cells);
    if (!(glm::length(cells - whole) < 1e-3) || glm::any(glm::greaterThan(glm::abs(whole), glm::dvec3(kMaxGridSize))))
        return std::nullopt;
    return glm::ivec3(whole);
}

/// Whether a voxel of `shape` has a face in common with one of `into`.
bool sharesFace(const VoxelGrid& into, const VoxelGrid& shape, glm::ivec3 offset) {
    bool found = false;
    shape.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        const glm::ivec3 low = position * kBrickSize + offset;
        if (found || glm::any(glm::greaterThan(low, into.size())) ||
            glm::any(glm::lessThan(low + kBrickSize, glm::ivec3(0))))
            return;
        forEachVoxel(brick->occupancy, [&](int i) {
            for (const glm::ivec3 step : kFaceOffsets) found = found || into.at(low + voxelInBrick(i) + step) != 0;
        });
    });
    return found;
}

Shape* shapeToEdit(EditContext& context, ShapeHandle handle, const char* edit) {
    releaseFragments(context);  // their cells are those of the shape as it is now
    Shape* shape = context.world.shapes.find(handle);
    if (!shape) context.warnStale(std::string(edit) + ": the handle of its shape is stale; nothing was done");
    return shape;
}

ShapeHandle findMergeTarget(const EditContext& context, ShapeHandle handle) {
    const Shape& shape = context.world.shapes.at(handle);
    for (const ShapeHandle other : context.world.bodies.at(shape.body).shapes) {
        if (other == handle) continue;
        const Shape& into = context.world.shapes.at(other);
        if (const auto offset = cellOffsetIn(into, shape); offset && sharesFace(into.grid, shape.grid, *offset))
            return other;
    }
    return {};
}

/// Adds the voxels of `from`, whose cell 0 is cell `at` of `into`, and lists the bricks that got some. Returns the
/// counts of those whose cell is taken.
EntryCounts mergeVoxels(Shape& into, const Shape& from, const std::array<uint8_t, 256>& entries, glm::ivec3 at,
                        BrickSet& filled) {
    std::array<uint8_t, 16> paints{};
    if (from.paintColors) {
        auto colors = std::make_shared<PaintColors>(into.paintColors ? *into.paintColors : PaintColors{});
        paints = mergePaintColors(*colors, *from.paintColors);
        into.paintColors = colors;
    }
    EntryCounts lost{};
    {
        GridWriter writer(into.grid);
        from.grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                const glm::ivec3 cell = position * kBrickSize + voxelInBrick(i) + at;
                if (writer.at(cell)) return void(++lost[brick->at(i)]);
                const uint8_t paint = brick->paintAt(i);
                filled.insert(brickOfCell(cell));
                writer.set(cell, entries[brick->at(i)], uint8_t(paint ? paints[paint >> 4] << 4 | (paint & 15) : 0));
            });
        });
    }
    return lost;
}

/// What is merged into a connected shape may have loose parts, or may be waiting for the test that finds them.
void moveConnectivity(EditContext& context, ShapeHandle from, ShapeHandle target) {
    Shape& into = context.world.shapes.at(target);
    bool isTested = true, isBroken = context.world.shapes.at(from).broken;
    for (PendingSplit& pending : context.world.pendingSplits) {
        isTested = isTested && pending.shape != from;
        if (pending.shape == target) pending.search.reset();  // it has not seen the new voxels
    }
    if (const auto known = context.editStates.find(from.slot()); known != context.editStates.end()) {
        isTested = isTested && !known->second.isBroken() && !known->second.lostVoxels;
        isBroken = isBroken || known->second.isBroken();
        context.editStates.erase(known);
    }
    if (isBroken) context.editState(target).brokeBefore = true;
    if (!isTested) context.editState(target).lostVoxels = true;
    into.knownConnected = into.knownConnected && isTested && context.world.shapes.at(from).knownConnected;
}

/// Lights and joints of a shape that is merged into another go with it.
void moveAttached(EditContext& context, ShapeHandle from, ShapeHandle into, glm::ivec3 at) {
    context.world.lights.forEach([&](LightHandle light, Light& attached) {
        if (attached.shape != from) return;
        attached.shape = into;
        attached.local.position += glm::dvec3(at) * double(context.world.shapes.at(into).voxelSize);
        context.changes.lights.push_back(light);
    });
    for (const JointHandle joint : copyOf(context.world.jointIndex.of(from)))
        for (size_t end = 0; end < 2; ++end)
            if (context.world.joints.at(joint).ends[end].shape == from) moveJointEnd(context, joint, end, into, -at);
}

}  // namespace

void apply(EditContext& context, const SplitShapeEdit& edit) {
    Shape* shape = shapeToEdit(context, edit.shape, "split_shape");
    if (!shape) return;
    context.recordMotion(shape->body);
    std::vector<Component> components = findComponents(shape->grid);
    const auto keeps = [&](const Component& a, const Component& b) {
        const bool holdsA = touchesAnchor(shape->grid, a, shape->anchors),
                   holdsB = touchesAnchor(shape->grid, b, shape->anchors);
        return holdsA != holdsB ? holdsA : isLargerComponent(a, b);
    };
    if (components.size() <= 1) return;
    components.erase(std::min_element(components.begin(), components.end(), keeps));
    const Densities densities(*shape->palette, context.world.materials);
    ShapeSplit split{.parent = edit.shape};
    const Body& body = context.world.bodies.at(shape->body);
    for (const Component& component : components) {
        const MassMoments moments = componentMoments(shape->grid, component, densities);
        ShapeEditState& each = context.editState(edit.shape);
        each.carved.insert(component);
        each.lost = {glm::ivec3(0), shape->grid.size()};
        shape->moments -= moments;
        if (edit.removeResidual && component.voxels < edit.residualVoxels) {
            discardPiece(context, edit.shape, component);
            continue;
        }
        Piece piece = takePiece(shape->grid, component);
        const MassProperties mass = massOf(*shape, moments);
        split.motions.push_back({shapeToWorld(context.world, edit.shape).transformPoint(mass.center), body.velocity,
                                 body.angularVelocity, mass.mass});
        split.parentOffset.push_back(piece.offset);
        split.children.push_back(createSplitShape(context, edit.shape, std::move(piece), moments));
        shape = &context.world.shapes.at(edit.shape);  // inserting a shape may have moved the others
    }
    shape->knownConnected = true;
    if (split.children.empty()) return;
    moveLights(context, split);
    moveJoints(context, split);
    moveHeat(context, split);
    context.changes.splits.push_back(std::move(split));
}

void apply(EditContext& context, const MergeShapeEdit& edit) {
    Shape* from = shapeToEdit(context, edit.shape, "merge_shape");
    if (!from) return;
    const ShapeHandle target = edit.into ? edit.into : findMergeTarget(context, edit.shape);
    Shape* into = target == edit.shape ? nullptr : context.world.shapes.find(target);
    const std::optional<glm::ivec3> offset = into ? cellOffsetIn(*into, *from) : std::nullopt;
    if (!offset || !sharesFace(into->grid, from->grid, *offset))
        return logWarning("merge shapes: no shape that matches and touches; nothing was done");
    const CellBox box{glm::min(*offset, glm::ivec3(0)), glm::max(*offset + from->grid.size(), into->grid.size())};
    auto palette = std::make_shared<Palette>(*into->palette);
    const auto entries = mergePalette(*palette, usedEntries(into->grid), *from->palette, usedEntries(from->grid));
    if (!entries)
        return logWarning("merge shapes: the two palettes do not fit into one of 255 entries; nothing was done");
    if (!reframeShape(context, target, box)) return;
    const glm::ivec3 at = *offset - box.low;
    const auto looksBefore = std::pair(into->palette, into->paintColors);
    if (*palette != *into->palette) into->palette = palette;
    const EntryCounts lost = mergeVoxels(*into, *from, *entries, at, context.editState(target).filled);
    if (looksBefore != std::pair(into->palette, into->paintColors)) context.listPalette(target);
    for (const CellBox& anchor : from->anchors) into->anchors.push_back({anchor.low + at, anchor.high + at});
    if (!from->anchors.empty()) context.changes.filters.push_back(target);
    into->moments = gridMoments(into->grid, *into->palette, context.world.materials);
    moveAttached(context, edit.shape, target, at);
    moveConnectivity(context, edit.shape, target);
    context.recordRemoved(edit.shape, lost, {shapeToWorld(context.world, edit.shape).transformPoint({}), 0.0, {}});
    moveSupplies(context, edit.shape, target, at);
    destroyShape(context, edit.shape);
    context.wakeBody(into->body);
}

void apply(EditContext& context, const TrimShapeEdit& edit) {
    if (const Shape* shape = shapeToEdit(context, edit.shape, "trim_shape"))
        reframeShape(context, edit.shape, filledBounds(shape->grid));
}

void apply(EditContext& context, const ResizeShapeEdit& edit) {
    if (shapeToEdit(context, edit.shape, "resize_shape")) reframeShape(context, edit.shape, edit.box);
}

}  // namespace rubble
