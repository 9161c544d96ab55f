#include <algorithm>

#include "runtime/core/log.h"
#include "runtime/core/number_range.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {
namespace {

std::vector<JointHandle> copyOf(std::span<const JointHandle> joints) {
    return {joints.begin(), joints.end()};
}

/// Where a rope comes nearest to a place: the number of a point, and how far on to the next.
double nearestOnRope(const Joint& rope, glm::dvec3 place) {
    double best = 0.0, nearest = 1e300;
    for (size_t i = 0; i + 1 < rope.points.size(); ++i) {
        const glm::dvec3 from = rope.points[i].position, segment = rope.points[i + 1].position - from;
        const double length2 = glm::dot(segment, segment);
        const double along = length2 > 0.0 ? std::clamp(glm::dot(place - from, segment) / length2, 0.0, 1.0) : 0.0;
        const glm::dvec3 away = from + segment * along - place;
        if (glm::dot(away, away) >= nearest) continue;
        nearest = glm::dot(away, away);
        best = double(i) + along;
    }
    return best;
}

}  // namespace

void EditStep::apply(const AddJointEdit& edit) {
    Joint joint = edit.joint;
    if (const std::string error = m_world.resolveJoint(joint); !error.empty())
        return logWarning("AddJointEdit: " + error + "; no joint was made");
    m_changes.jointsCreated.push_back(m_world.addJoint(std::move(joint)));
}

void EditStep::apply(const RemoveJointEdit& edit) {
    const Joint* joint = m_world.m_joints.find(edit.joint);
    if (!joint) {
        if (edit.reason != JointBreak::Force)
            logWarning("RemoveJointEdit: the handle of its joint is stale; nothing was removed");
        return;
    }
    if (joint->kind == JointKind::Rope && edit.reason != JointBreak::Removed) {
        const double middle = edit.reason == JointBreak::Force ? 0.5 * double(joint->points.size() - 1)
                                                               : nearestOnRope(*joint, edit.place);
        if (cutRope(edit.joint, middle, edit.reason)) return;
    }
    breakJoint(edit.joint, edit.reason, m_world.jointToWorld(joint->ends[0]).position);
}

void EditStep::apply(const SetJointMotorEdit& edit) {
    Joint* joint = m_world.m_joints.find(edit.joint);
    if (!joint) return logWarning("SetJointMotorEdit: the handle of its joint is stale; nothing was set");
    Joint wanted = *joint;
    wanted.motor = edit.motor;
    wanted.friction = edit.friction;
    wanted.steer = edit.steer;
    if (const std::string error = jointError(wanted); !error.empty())
        return logWarning("SetJointMotorEdit: " + error + "; nothing was set");
    *joint = std::move(wanted);
    m_changes.jointsChanged.push_back(edit.joint);
}

void EditStep::apply(const DetachJointEdit& edit) {
    const Joint* joint = m_world.m_joints.find(edit.joint);
    if (!joint) return logWarning("DetachJointEdit: the handle of its joint is stale; nothing was detached");
    for (size_t end = 0; end < 2; ++end)
        if (joint->ends[end].shape == edit.shape && !joint->ends[end].isFree) {
            if (joint->kind != JointKind::Rope)
                return breakJoint(edit.joint, JointBreak::Removed, m_world.jointToWorld(joint->ends[end]).position);
            releaseEnd(edit.joint, end);
            joint = &m_world.m_joints.at(edit.joint);
        }
}

void EditStep::apply(const GrabEdit& edit) {
    const Body* body = m_world.m_bodies.find(edit.body);
    if (!body || body->isStatic)
        return logWarning("GrabEdit: its handle is stale, or names a static body; nothing was grabbed");
    if (!isWithin(edit.point, 1e12) || !isWithin(edit.target, 1e12))
        return logWarning("GrabEdit: a place is no finite number; nothing was grabbed");
    for (const JointHandle handle : copyOf(m_world.m_jointIndex.grabs())) {
        Joint& grab = m_world.m_joints.at(handle);
        if (grab.hand != edit.hand + 1) continue;
        if (m_world.m_shapes.at(grab.ends[0].shape).body != edit.body) {
            breakJoint(handle, JointBreak::Removed, edit.point);
            continue;
        }
        if (grab.ends[1].frame.position == edit.target && grab.maxForce == edit.maxForce &&
            grab.spring.hertz == edit.hertz)
            return;
        Joint moved = grab;
        moved.ends[1].frame.position = edit.target;
        moved.maxForce = edit.maxForce;
        moved.spring.hertz = edit.hertz;
        if (!jointError(moved).empty())
            return logWarning("GrabEdit: " + jointError(moved) + "; the grab stays as it was");
        grab = std::move(moved);
        m_changes.jointsChanged.push_back(handle);
        return;
    }
    for (const ShapeHandle shape : body->shapes) {
        Joint grab = jointAt(m_world, JointKind::Ball, shape, {}, {edit.point});
        grab.name = "grab";
        grab.ends[1].frame.position = edit.target;
        grab.collides = true;
        grab.spring = {edit.hertz, 1.0};
        grab.maxForce = edit.maxForce;
        grab.friction = 0.1 * edit.maxForce;
        grab.hand = edit.hand + 1;
        if (!m_world.resolveJoint(grab).empty()) continue;
        m_changes.jointsCreated.push_back(m_world.addJoint(std::move(grab)));
        return;
    }
    logWarning("GrabEdit: the body has no voxel at that point; nothing was grabbed");
}

void EditStep::apply(const ReleaseEdit& edit) {
    for (const JointHandle handle : copyOf(m_world.m_jointIndex.grabs())) {
        const Joint& grab = m_world.m_joints.at(handle);
        if (grab.hand != edit.hand + 1) continue;
        const glm::dvec3 place = m_world.jointToWorld(grab.ends[0]).position;
        const BodyHandle body = m_world.m_shapes.at(grab.ends[0].shape).body;
        breakJoint(handle, JointBreak::Removed, place);
        if (edit.impulse != glm::dvec3(0.0)) apply(ImpulseEdit{body, place, edit.impulse});
    }
}

void EditStep::breakJoint(JointHandle handle, JointBreak reason, glm::dvec3 position) {
    m_world.m_jointIndex.remove(handle, m_world.m_joints.at(handle));
    m_world.m_joints.erase(handle);
    m_changes.jointsBroken.push_back({handle, reason, position});
    std::erase(m_changes.jointsCreated, handle);
}

/// An end goes into another frame of cells, whose cell 0 is at `cellOffset` of those that it is in now.
void EditStep::moveJointEnd(JointHandle handle, size_t end, ShapeHandle to, glm::ivec3 cellOffset) {
    Joint& joint = m_world.m_joints.at(handle);
    m_world.m_jointIndex.remove(handle, joint);
    JointEnd& moved = joint.ends[end];
    if (moved.shape != to) m_changes.jointsMoved.push_back({handle, moved.shape, to});
    moved.shape = to;
    moved.cell -= cellOffset;
    moved.frame.position -= glm::dvec3(cellOffset) * double(m_world.m_shapes.at(to).voxelSize);
    m_world.m_jointIndex.add(handle, joint);
}

/// Joints go with the voxels that they are fixed to.
void EditStep::moveJoints(const ShapeSplit& split) {
    for (const JointHandle handle : copyOf(m_world.jointsOf(split.parent)))
        for (size_t end = 0; end < 2; ++end) {
            const JointEnd& held = m_world.m_joints.at(handle).ends[end];
            if (held.shape != split.parent || m_world.m_shapes.at(split.parent).grid.at(held.cell)) continue;
            for (size_t i = 0; i < split.children.size(); ++i) {
                if (!m_world.m_shapes.at(split.children[i]).grid.at(held.cell - split.parentOffset[i])) continue;
                moveJointEnd(handle, end, split.children[i], split.parentOffset[i]);
                break;
            }
        }
}

void EditStep::reframeJoints(ShapeHandle shape, glm::ivec3 low) {
    for (const JointHandle handle : copyOf(m_world.jointsOf(shape))) {
        for (size_t end = 0; end < 2; ++end)
            if (m_world.m_joints.at(handle).ends[end].shape == shape) moveJointEnd(handle, end, shape, low);
        m_changes.jointsChanged.push_back(handle);
    }
}

/// The shape is about to go.
void EditStep::releaseJointsOf(ShapeHandle shape) {
    for (const JointHandle handle : copyOf(m_world.jointsOf(shape)))
        for (size_t end = 0; end < 2; ++end)
            if (const Joint* joint = m_world.m_joints.find(handle); joint && joint->ends[end].shape == shape)
                releaseEnd(handle, end);
}

/// What an end was fixed to is gone: a rope hangs on, other joints break.
void EditStep::releaseEnd(JointHandle handle, size_t end) {
    Joint& joint = m_world.m_joints.at(handle);
    const glm::dvec3 place = m_world.jointToWorld(joint.ends[end]).position;
    if (joint.kind != JointKind::Rope || joint.ends[1 - end].isFree)
        return breakJoint(handle, JointBreak::VoxelGone, place);
    m_world.m_jointIndex.remove(handle, joint);
    joint.ends[end] = {.frame = {place}, .isFree = true};
    m_world.m_jointIndex.add(handle, joint);
    m_changes.jointsChanged.push_back(handle);
}

/// Voxels are gone that held joints.
void EditStep::releaseUnheldJoints() {
    if (m_world.m_joints.size() == 0) return;
    for (const auto& [slot, each] : m_editStates)
        for (const JointHandle handle : copyOf(m_world.jointsOf(each.shape)))
            for (size_t end = 0; end < 2; ++end) {
                const Joint* joint = m_world.m_joints.find(handle);
                if (!joint || joint->ends[end].shape != each.shape) continue;
                if (!m_world.m_shapes.at(each.shape).grid.at(joint->ends[end].cell)) releaseEnd(handle, end);
            }
}

}  // namespace rubble
