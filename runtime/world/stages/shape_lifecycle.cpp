#include "runtime/world/stages/shape_lifecycle.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/planted_fault.h"
#include "runtime/world/objects/body_mass.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/stages/entry_counts.h"
#include "runtime/world/stages/heat_moves.h"
#include "runtime/world/stages/joint_stage.h"
#include "runtime/world/stages/light_stage.h"
#include "runtime/world/stages/note_edits.h"

namespace rubble {

namespace {

/// What a body that came off another keeps of how that moves.
void inheritMotion(const Body& from, Body& body) {
    body.gravityScale = from.gravityScale;
    body.linearDamping = from.linearDamping;
    body.angularDamping = from.angularDamping;
}

}  // namespace

ShapeHandle createPiece(EditContext& context, ShapeHandle parentHandle, Piece piece, const MassMoments& moments,
                        PieceMotion& motion) {
    const Shape& parent = context.world.shapes.at(parentHandle);
    const Body& from = context.world.bodies.at(parent.body);
    Body body{.name = parent.name};
    body.isStatic = false;
    body.pose = shapeToWorld(context.world, parentHandle) * Pose{glm::dvec3(piece.offset) * double(parent.voxelSize)};
    body.createdStep = context.changes.step;
    inheritMotion(from, body);
    const MassProperties mass = massOf(parent, moments.shifted(-piece.offset));
    motion = {.center = body.pose.transformPoint(mass.center), .mass = mass.mass};
    if (!from.isStatic) {
        const BodyMotion& before = context.motions.at(parent.body.slot());
        motion.velocity = body.velocity = before.velocityAt(motion.center);
        motion.angularVelocity = body.angularVelocity = before.angularVelocity;
    }
    Shape shape{.name = parent.name, .voxelSize = parent.voxelSize};
    shape.grid = std::move(piece.grid);
    shape.palette = parent.palette;
    shape.paintColors = parent.paintColors;
    shape.moments = moments.shifted(-piece.offset);
    shape.tags = parent.tags;
    shape.loadBearing = parent.loadBearing;
    shape.strength = parent.strength;
    shape.density = parent.density;
    shape.emission = parent.emission;
    shape.collisionLayer = parent.collisionLayer;
    shape.collisionMask = parent.collisionMask;
    shape.collisionShape = parent.collisionShape;
    shape.isPiece = true;
    shape.knownConnected = true;
    const BodyHandle bodyHandle = context.world.bodies.insert(std::move(body));
    shape.body = bodyHandle;
    const ShapeHandle handle = context.world.shapes.insert(std::move(shape));
    context.world.bodies.at(bodyHandle).shapes.push_back(handle);
    context.world.updateShapeBounds(handle);
    context.world.updateDebris(bodyHandle);
    context.changes.bodiesCreated.push_back(bodyHandle);
    context.changes.shapesCreated.push_back(handle);
    inheritNote(context, parentHandle, handle);
    return handle;
}

ShapeHandle createSplitShape(EditContext& context, ShapeHandle handle, Piece piece, const MassMoments& moments) {
    const Shape& from = context.world.shapes.at(handle);
    Shape shape = from;
    shape.local = from.local * Pose{glm::dvec3(piece.offset) * double(from.voxelSize)};
    shape.anchors = translatedBoxes(from.anchors, piece.offset, piece.grid.size());
    shape.grid = std::move(piece.grid);
    shape.moments = moments.shifted(-piece.offset);
    shape.knownConnected = true;
    const BodyHandle body = shape.body;
    const ShapeHandle sibling = context.world.shapes.insert(std::move(shape));
    context.world.bodies.at(body).shapes.push_back(sibling);
    context.world.updateShapeBounds(sibling);
    context.world.updateDebris(body);
    context.changes.shapesCreated.push_back(sibling);
    inheritNote(context, handle, sibling);
    return sibling;
}

void detachToNewBody(EditContext& context, ShapeHandle handle) {
    Body body{.name = context.world.shapes.at(handle).name};
    body.isStatic = false;
    body.pose = shapeToWorld(context.world, handle);
    body.shapes = {handle};
    body.createdStep = context.changes.step;
    body.broken = context.world.shapes.at(handle).broken;
    inheritMotion(context.world.bodies.at(context.world.shapes.at(handle).body), body);
    const BodyHandle newBody = context.world.bodies.insert(std::move(body));
    Shape& shape = context.world.shapes.at(handle);
    const BodyHandle oldBody = shape.body;
    std::vector<ShapeHandle>& left = context.world.bodies.at(oldBody).shapes;
    std::erase(left, handle);
    context.changes.lostShapes.push_back(oldBody);
    if (left.empty()) {
        context.world.bodies.erase(oldBody);
        context.changes.bodiesDestroyed.push_back(oldBody);
    }
    shape.body = newBody;
    shape.local = {};
    shape.anchors.clear();
    shape.isPiece = true;
    context.world.updateDebris(oldBody);
    context.world.updateDebris(newBody);
    context.changes.bodiesCreated.push_back(newBody);
    context.changes.unanchored.push_back(handle);
    for (const JointHandle joint : context.world.jointIndex.of(handle)) context.changes.jointsChanged.push_back(joint);
    context.world.lights.forEach([&](LightHandle light, const Light& attached) {
        if (attached.shape == handle) context.changes.lights.push_back(light);
    });
}

void discardPiece(EditContext& context, ShapeHandle parent, const Component& component) {
    Shape& shape = context.world.shapes.at(parent);
    std::array<uint64_t, 256> removed{};
    forEachSubset(shape.grid, component, [&](glm::ivec3, const Brick& brick, const BrickBits& voxels) {
        forEachVoxel(voxels, [&](int i) { ++removed[brick.at(i)]; });
    });
    const Densities densities(*shape.palette, context.world.materials);
    const MassProperties mass = massProperties(componentMoments(shape.grid, component, densities), shape.voxelSize);
    takePiece(shape.grid, component);
    const double radius = 0.5 * shape.voxelSize * std::cbrt(double(component.voxels));
    context.recordRemoved(parent, removed,
                          {shapeToWorld(context.world, parent).transformPoint(mass.center), radius,
                           context.world.bodies.at(shape.body).velocity});
}

void eraseEmptyShape(EditContext& context, ShapeHandle handle) {
    turnOffLightsOf(context, handle);
    releaseJointsOf(context, handle);
    dropHeat(context, handle);
    const BodyHandle body = context.world.shapes.at(handle).body;
    context.world.removeShapeBounds(handle);
    context.world.shapes.erase(handle);
    context.changes.shapesDestroyed.push_back(handle);
    std::erase(context.world.bodies.at(body).shapes, handle);
    context.changes.lostShapes.push_back(body);
    context.world.updateDebris(body);
}

void destroyShape(EditContext& context, ShapeHandle handle) {
    const BodyHandle body = context.world.shapes.at(handle).body;
    eraseEmptyShape(context, handle);
    if (!context.world.bodies.at(body).shapes.empty() || isPlanted("leaked-body")) return;
    context.world.bodies.erase(body);
    context.changes.bodiesDestroyed.push_back(body);
    context.world.updateDebris(body);
}

void eraseShape(EditContext& context, ShapeHandle handle) {
    context.recordErased(handle, countEntries(context.world.shapes.at(handle).grid));
    destroyShape(context, handle);
}

void despawn(EditContext& context, BodyHandle handle) {
    const Body body = context.world.bodies.at(handle);
    for (const ShapeHandle shapeHandle : body.shapes) {
        const Shape& shape = context.world.shapes.at(shapeHandle);
        const glm::dvec3 half = glm::dvec3(shape.grid.size()) * (0.5 * shape.voxelSize);
        context.recordRemoved(
            shapeHandle, countEntries(shape.grid),
            {shapeToWorld(context.world, shapeHandle).transformPoint(half), glm::length(half), body.velocity});
        destroyShape(context, shapeHandle);
    }
}

}  // namespace rubble
