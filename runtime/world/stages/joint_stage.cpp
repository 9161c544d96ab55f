#include "runtime/world/stages/joint_stage.h"

#include <algorithm>
#include <string>

#include "runtime/core/log.h"
#include "runtime/world/objects/joint_attachment.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/stages/rope_stage.h"

namespace rubble {
namespace {

/// Where a rope comes nearest to a place: the index of a point, and the share of the segment to the next one.
double nearestOnRope(const Joint& rope, glm::dvec3 place) {
    double best = 0.0, nearest = 1e300;
    for (size_t i = 0; i + 1 < rope.points.size(); ++i) {
        const glm::dvec3 from = rope.points[i].position, segment = rope.points[i + 1].position - from;
        const double length2 = glm::dot(segment, segment);
        const double along = length2 > 0.0 ? std::clamp(glm::dot(place - from, segment) / length2, 0.0, 1.0) : 0.0;
        const glm::dvec3 offset = from + segment * along - place;
        if (glm::dot(offset, offset) >= nearest) continue;
        nearest = glm::dot(offset, offset);
        best = double(i) + along;
    }
    return best;
}

/// Nothing holds an end any more: a rope stays with a free end, unless its other end is free too; other joints break.
void releaseEnd(EditContext& context, JointHandle handle, size_t end, JointBreak reason) {
    Joint& joint = context.world.joints.at(handle);
    const glm::dvec3 place = jointToWorld(context.world, joint.ends[end]).position;
    if (joint.kind != JointKind::Rope || joint.ends[1 - end].isFree) return breakJoint(context, handle, reason, place);
    context.world.jointIndex.remove(handle, joint);
    context.changes.jointsMoved.push_back({handle, joint.ends[end].shape, {}, place});
    joint.ends[end] = {.frame = {place}, .isFree = true};
    context.world.jointIndex.add(handle, joint);
    context.changes.jointsChanged.push_back(handle);
}

}  // namespace

std::vector<JointHandle> copyOf(std::span<const JointHandle> joints) {
    return {joints.begin(), joints.end()};
}

void apply(EditContext& context, const AddJointEdit& edit) {
    Joint joint = edit.joint;
    if (edit.inWorld)
        for (JointEnd& end : joint.ends) placeEnd(context.world, end);
    if (const std::string error = attachJoint(context.world, joint); !error.empty()) return context.refuse(error);
    const JointHandle handle = context.make(context.world.joints, std::move(joint));
    context.world.jointIndex.add(handle, context.world.joints.at(handle));
    context.changes.jointsCreated.push_back(handle);
}

void apply(EditContext& context, const RemoveJointEdit& edit) {
    const Joint* joint = context.world.joints.find(edit.joint);
    if (!joint) {
        if (edit.reason != JointBreak::Force)
            context.warnStale("remove_joint: the handle of its joint is stale; nothing was removed");
        return;
    }
    if (joint->kind == JointKind::Rope && edit.reason != JointBreak::Removed) {
        const double middle = edit.reason == JointBreak::Force ? 0.5 * double(joint->points.size() - 1)
                                                               : nearestOnRope(*joint, edit.place);
        if (cutRope(context, edit.joint, middle, edit.reason)) return;
    }
    breakJoint(context, edit.joint, edit.reason, jointToWorld(context.world, joint->ends[0]).position);
}

void apply(EditContext& context, const SetJointMotorEdit& edit) {
    Joint* joint = context.world.joints.find(edit.joint);
    if (!joint) return context.warnStale("set_joint_motor: the handle of its joint is stale; nothing was set");
    if (const std::string error = jointMotorError(joint->kind, edit.motor); !error.empty())
        return logWarning("set_joint_motor: " + error + "; nothing was set");
    joint->motor = edit.motor;
    joint->friction = edit.friction;
    joint->steer = joint->steerTarget = edit.steer;
    context.world.jointIndex.updateDrive(edit.joint, *joint);
    context.changes.jointsChanged.push_back(edit.joint);
}

void apply(EditContext& context, const DetachJointEdit& edit) {
    if (!context.world.joints.find(edit.joint))
        return context.warnStale("detach joint: the handle of its joint is stale; nothing was detached");
    for (size_t end = 0; end < 2; ++end) {
        const Joint* joint = context.world.joints.find(edit.joint);
        if (joint && joint->ends[end].shape == edit.shape && !joint->ends[end].isFree)
            releaseEnd(context, edit.joint, end, JointBreak::Removed);
    }
}

void breakJoint(EditContext& context, JointHandle handle, JointBreak reason, glm::dvec3 position) {
    context.world.jointIndex.remove(handle, context.world.joints.at(handle));
    context.world.joints.erase(handle);
    context.changes.jointsBroken.push_back({handle, reason, position});
    std::erase(context.changes.jointsCreated, handle);
}

void moveJointEnd(EditContext& context, JointHandle handle, size_t end, ShapeHandle to, glm::ivec3 cellOffset) {
    Joint& joint = context.world.joints.at(handle);
    context.world.jointIndex.remove(handle, joint);
    JointEnd& moved = joint.ends[end];
    if (moved.shape != to) context.changes.jointsMoved.push_back({handle, moved.shape, to});
    moved.shape = to;
    moved.cell -= cellOffset;
    moved.frame.position -= glm::dvec3(cellOffset) * double(context.world.shapes.at(to).voxelSize);
    context.world.jointIndex.add(handle, joint);
}

void moveJoints(EditContext& context, const ShapeSplit& split) {
    for (const JointHandle handle : copyOf(context.world.jointIndex.of(split.parent)))
        for (size_t end = 0; end < 2; ++end) {
            const JointEnd& held = context.world.joints.at(handle).ends[end];
            if (held.shape != split.parent || context.world.shapes.at(split.parent).grid.at(held.cell)) continue;
            for (size_t i = 0; i < split.children.size(); ++i) {
                if (!context.world.shapes.at(split.children[i]).grid.at(held.cell - split.parentOffset[i])) continue;
                moveJointEnd(context, handle, end, split.children[i], split.parentOffset[i]);
                break;
            }
        }
}

void reframeJoints(EditContext& context, ShapeHandle shape, glm::ivec3 low) {
    for (const JointHandle handle : copyOf(context.world.jointIndex.of(shape))) {
        for (size_t end = 0; end < 2; ++end)
            if (context.world.joints.at(handle).ends[end].shape == shape)
                moveJointEnd(context, handle, end, shape, low);
        context.changes.jointsChanged.push_back(handle);
    }
}

void releaseJointsOf(EditContext& context, ShapeHandle shape) {
    for (const JointHandle handle : copyOf(context.world.jointIndex.of(shape)))
        for (size_t end = 0; end < 2; ++end)
            if (const Joint* joint = context.world.joints.find(handle); joint && joint->ends[end].shape == shape)
                releaseEnd(context, handle, end, JointBreak::VoxelGone);
}

void releaseUnheldJoints(EditContext& context) {
    if (context.world.joints.size() == 0) return;
    for (const auto& [slot, each] : context.editStates)
        for (const JointHandle handle : copyOf(context.world.jointIndex.of(each.shape)))
            for (size_t end = 0; end < 2; ++end) {
                const Joint* joint = context.world.joints.find(handle);
                if (!joint || joint->ends[end].shape != each.shape) continue;
                if (!context.world.shapes.at(each.shape).grid.at(joint->ends[end].cell))
                    releaseEnd(context, handle, end, JointBreak::VoxelGone);
            }
}

}  // namespace rubble
