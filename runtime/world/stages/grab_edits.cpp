#include "runtime/world/stages/grab_edits.h"

#include <string>
#include <tuple>

#include "runtime/core/log.h"
#include "runtime/world/objects/joint_attachment.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/stages/joint_stage.h"

namespace rubble {
namespace {

constexpr double kGrabFriction = 0.1;  ///< N m against the rotation of what is held, for each N of its largest force

JointKind kindOf(const GrabEdit& edit) {
    return edit.turns ? JointKind::Fixed : JointKind::Ball;
}
/// Where a grab pulls the body's point, and the body's axes if it turns them.
Pose targetOf(const GrabEdit& edit) {
    return {edit.target, edit.turns ? edit.rotation : glm::dquat(1, 0, 0, 0)};
}

/// Gives a grab its target and strength. Returns whether it had others.
bool setTarget(Joint& grab, const GrabEdit& edit) {
    const auto target = [](const Joint& joint) {
        return std::tie(joint.ends[1].frame.position, joint.ends[1].frame.rotation, joint.maxForce, joint.maxTorque,
                        joint.spring.hertz, joint.drives, joint.velocity, joint.angularVelocity);
    };
    const Joint before = grab;
    grab.ends[1].frame = targetOf(edit);
    grab.maxForce = edit.maxForce;
    grab.maxTorque = edit.maxTorque;
    grab.spring.hertz = edit.drives ? 0.0 : edit.hertz;
    grab.drives = edit.drives;
    grab.velocity = edit.velocity;
    grab.angularVelocity = edit.angularVelocity;
    return target(before) != target(grab);
}

}  // namespace

void apply(EditContext& context, const GrabEdit& edit) {
    const Body* body = context.world.bodies.find(edit.body);
    if (!body || body->isStatic)
        return context.warnStale(
            "grab_body: expected the handle of a free body, found one that is stale or static; nothing was grabbed");
    glm::dvec3 point = edit.point;
    for (const JointHandle handle : copyOf(context.world.jointIndex.grabs())) {
        const Joint& grab = context.world.joints.at(handle);
        if (grab.hand != edit.hand + 1) continue;
        const bool isHeld = context.world.shapes.at(grab.ends[0].shape).body == edit.body;
        if (isHeld && grab.kind == kindOf(edit)) {
            if (setTarget(context.world.joints.at(handle), edit)) context.changes.jointsChanged.push_back(handle);
            return;
        }
        if (isHeld) point = jointToWorld(context.world, grab.ends[0]).position;  // a hand that begins to turn
        breakJoint(context, handle, JointBreak::Removed, point);
    }
    for (const ShapeHandle shape : body->shapes) {
        const glm::dquat axes = edit.turns ? body->pose.rotation : glm::dquat(1, 0, 0, 0);
        Joint grab = jointAt(context.world, kindOf(edit), shape, {}, {point, axes});
        grab.name = "grab";
        grab.collides = true;
        grab.spring.dampingRatio = 1.0;
        setTarget(grab, edit);
        if (!edit.turns) grab.friction = kGrabFriction * edit.maxForce;
        grab.hand = edit.hand + 1;
        if (!attachJoint(context.world, grab).empty()) continue;
        context.changes.jointsCreated.push_back(context.world.addJoint(std::move(grab)));
        return;
    }
    logWarning("grab_body: expected a voxel of the body near the point, found none; nothing was grabbed");
}

void apply(EditContext& context, const ReleaseEdit& edit) {
    for (const JointHandle handle : copyOf(context.world.jointIndex.grabs())) {
        const Joint& grab = context.world.joints.at(handle);
        if (grab.hand != edit.hand + 1) continue;
        const glm::dvec3 place = jointToWorld(context.world, grab.ends[0]).position;
        const BodyHandle body = context.world.shapes.at(grab.ends[0].shape).body;
        breakJoint(context, handle, JointBreak::Removed, place);
        if (edit.impulse != glm::dvec3(0.0)) context.impulses.emplace_back(ImpulseEdit{body, place, edit.impulse});
    }
}

}  // namespace rubble
