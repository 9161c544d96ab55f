#include "runtime/world/stages/body_edits.h"

#include <algorithm>

#include "runtime/world/objects/body_mass.h"
#include "runtime/world/stages/shape_lifecycle.h"
#include "runtime/world/stages/split_stage.h"
#include "runtime/world/state/load_level.h"

namespace rubble {
namespace {

/// Physics, shadow volume and renderer know a static shape by its place: where that changes it is another shape to
/// them.
void moveShapes(EditContext& context, const Body& body) {
    for (const ShapeHandle shape : body.shapes) {
        context.world.updateShapeBounds(shape);
        for (const JointHandle joint : context.world.jointIndex.of(shape))
            context.changes.jointsChanged.push_back(joint);
        context.world.lights.forEach([&](LightHandle light, const Light& attached) {
            if (attached.shape == shape) context.changes.lights.push_back(light);
        });
        if (!body.isStatic) continue;
        context.changes.shapesDestroyed.push_back(shape);
        context.changes.shapesCreated.push_back(shape);
        ShapeEditState& state = context.editState(shape);
        if (!state.isChanged()) context.changes.relocated.push_back(shape);
        const bool isBroken = state.isBroken(), lostVoxels = isBroken || state.lostVoxels;
        if (lostVoxels) context.world.shapes.at(shape).knownConnected = false;
        // Its bricks are handed over with the shape.
        state = {.shape = shape, .lostVoxels = lostVoxels, .brokeBefore = isBroken};
    }
}

/// To physics, shadow volume and renderer a static body and a free one are two different ones.
void setKind(EditContext& context, BodyHandle handle, bool isStatic) {
    Body& body = context.world.bodies.at(handle);
    if (body.isStatic == isStatic) return;
    if (!isStatic) {
        moveShapes(context, body);  // lists them as static ones
        for (const ShapeHandle shape : body.shapes) context.world.shapes.at(shape).anchors.clear();
    }
    body.isStatic = isStatic;
    if (isStatic) {
        moveShapes(context, body);
        body.velocity = body.angularVelocity = glm::dvec3(0.0);
        body.asleep = body.waitsToWake = body.settled = false;
        body.restingSince = 0;
        context.motions.erase(handle.slot());
    }
    context.changes.bodiesDestroyed.push_back(handle);
    context.changes.bodiesCreated.push_back(handle);
    context.world.updateDebris(handle);
}

/// Pieces that come off later in this step move as the body does from now on.
void restartMotion(EditContext& context, BodyHandle handle) {
    const auto known = context.motions.find(handle.slot());
    if (known == context.motions.end() || known->second.body != handle) return;
    context.motions.erase(known);
    context.recordMotion(handle);
}

}  // namespace

void apply(EditContext& context, const SetBodyEdit& edit) {
    if (!context.world.bodies.find(edit.body))
        return context.warnStale(edit.body, "set_body: the handle of its body is stale; nothing was changed");
    releaseFragments(context);  // they came off where it was
    Body& body = context.world.bodies.at(edit.body);
    const bool becomesStatic = edit.setsKind && edit.isStatic && !body.isStatic;
    if (edit.setsKind) setKind(context, edit.body, edit.isStatic);
    if (edit.setsGravityScale) body.gravityScale = edit.gravityScale;
    if (edit.setsDamping) body.linearDamping = edit.linearDamping, body.angularDamping = edit.angularDamping;
    const bool isMoved = edit.setsPose && body.pose != edit.pose;
    if (isMoved) {
        body.pose = edit.pose;
        moveShapes(context, body);
        if (context.changes.isStill)  // as if the level had brought it there
            context.placedShapes.insert(context.placedShapes.end(), body.shapes.begin(), body.shapes.end());
    }
    if (becomesStatic)
        for (const ShapeHandle shape : body.shapes) anchorByDefault(context.world.shapes.at(shape), body);
    if (body.isStatic) {
        if (isMoved || edit.setsKind || edit.setsGravityScale || edit.setsDamping)
            context.changes.teleported.push_back(edit.body);
        return;
    }
    const bool isMadeAsleep = context.isNew(edit.body) && body.asleep;
    if (!isMadeAsleep || edit.setsVelocity || edit.setsSleep) context.wakeBody(edit.body);
    if (edit.setsVelocity) body.velocity = edit.velocity, body.angularVelocity = edit.angularVelocity;
    if (edit.setsSleep && edit.asleep) {
        body.velocity = body.angularVelocity = glm::dvec3(0.0);
        body.asleep = true;
        body.restingSince = context.changes.step;
    }
    restartMotion(context, edit.body);
    context.world.updateDebris(edit.body);
    std::vector<BodyHandle>& teleported = context.changes.teleported;
    if (std::find(teleported.begin(), teleported.end(), edit.body) == teleported.end()) teleported.push_back(edit.body);
    if (context.world.triggers.size()) context.world.movedBodies.push_back(edit.body);
}

void apply(EditContext& context, const DestroyBodyEdit& edit) {
    if (!context.world.bodies.find(edit.body))
        return context.warnStale(edit.body, "destroy_body: the handle of its body is stale; nothing was destroyed");
    releaseFragments(context);
    const std::vector<ShapeHandle> shapes = context.world.bodies.at(edit.body).shapes;
    for (const ShapeHandle shape : shapes) eraseShape(context, shape);
    if (!shapes.empty()) return;  // it went with its last shape
    context.world.bodies.erase(edit.body);
    context.changes.bodiesDestroyed.push_back(edit.body);
    context.world.updateDebris(edit.body);
}

}  // namespace rubble
