#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/rows.h"
#include "runtime/world/objects/joint_attachment.h"
#include "runtime/world/queries/joint_queries.h"

namespace rubble::abi {
namespace {

double readSize(double value, const char* name) {
    return readOrDefault(value, ranges::kJointNumber, 0.0, name);
}

double readSigned(double value, const char* name) {
    return readOrDefault(value, ranges::kJointTarget, 0.0, name);
}

JointMotor readMotor(uint32_t mode, double target, double maxForce) {
    return {MotorMode(readEnum(mode, RUBBLE_MOTOR_POSITION, "motor")), readSigned(target, "motor_target"),
            readSize(maxForce, "motor_max_force")};
}

/// The joint with its ends, placed in the world.
Joint readEnds(const World& world, const rubble_joint_settings& given) {
    const JointKind kind = JointKind(readEnum(given.kind, RUBBLE_JOINT_WHEEL, "kind"));
    std::array<ShapeHandle, 2> shapes;
    for (size_t i = 0; i < 2; ++i)
        shapes[i] = readOptionalHandle<HandleType::Shape>(world.shapes(), given.shapes[i], "shapes");
    const Pose frame{readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    Joint joint{.kind = kind};
    for (size_t i = 0; i < 2; ++i) joint.ends[i].shape = shapes[i], joint.ends[i].frame = frame;
    if (kind == JointKind::Rope) joint.ends[1].frame = {readVector(given.rope_end, "rope_end")};
    const double radius =
        readOrDefault(given.anchor_radius, ranges::kAnchorRadius, joint.ends[0].radius, "anchor_radius");
    joint.ends[0].radius = joint.ends[1].radius = radius;
    return joint;
}

AddJointEdit readJoint(const World& world, const rubble_joint_settings& given) {
    readFlags(given.flags, RUBBLE_JOINT_COLLIDES | RUBBLE_JOINT_LIMITED, "flags");
    Joint joint = readEnds(world, given);
    joint.collides = given.flags & RUBBLE_JOINT_COLLIDES;
    joint.limits = {(given.flags & RUBBLE_JOINT_LIMITED) != 0, readSigned(given.lower_limit, "lower_limit"),
                    readSigned(given.upper_limit, "upper_limit")};
    joint.motor = readMotor(given.motor, given.motor_target, given.motor_max_force);
    joint.spring = {readSize(given.spring_hertz, "spring_hertz"),
                    readSize(given.spring_damping_ratio, "spring_damping_ratio")};
    joint.friction = readSize(given.friction, "friction");
    joint.breakForce = readSize(given.break_force, "break_force");
    joint.breakTorque = readSize(given.break_torque, "break_torque");
    joint.rope.length = readSize(given.rope_length, "rope_length");
    joint.rope.radius = readOrDefault(given.rope_radius, ranges::kRopeRadius, joint.rope.radius, "rope_radius");
    joint.rope.stretch = readSize(given.rope_stretch, "rope_stretch");
    joint.rope.strength = readSize(given.rope_strength, "rope_strength");
    joint.wheel = {readSize(given.drive_torque, "drive_torque"),
                   readOrDefault(given.max_spin, ranges::kWheelSpin, joint.wheel.maxSpin, "max_spin"),
                   readSize(given.brake_torque, "brake_torque"),
                   readOrDefault(given.max_steer_angle, ranges::kSteerAngle, 0.0, "max_steer_angle"),
                   readOrDefault(given.steer_rate, ranges::kSteerRate, joint.wheel.steerRate, "steer_rate")};
    requireNoError(jointError(joint));
    if (!joint.ends[0].shape && !joint.ends[1].shape && joint.kind != JointKind::Rope)
        refuse(RUBBLE_ERROR_ARGUMENT, "shapes are both 0: neither end is on a shape");
    requireNoError(jointEndsError(joint));
    requireNoError(jointBodiesError(joint.kind, world.shapes().find(joint.ends[0].shape),
                                    world.shapes().find(joint.ends[1].shape)));
    return {joint, true};
}

SetJointMotorEdit readJointMotor(const World& world, const rubble_joint_motor& given) {
    const SetJointMotorEdit edit{readLiveHandle<HandleType::Joint>(world.joints(), given.joint, "joint"),
                                 readMotor(given.motor, given.motor_target, given.motor_max_force),
                                 readSize(given.friction, "friction"),
                                 readOrDefault(given.steer_angle, ranges::kSteer, 0.0, "steer_angle")};
    if (const Joint* joint = world.joints().find(edit.joint)) requireNoError(jointMotorError(joint->kind, edit.motor));
    return edit;
}

DriveEdit readDrive(const World& world, const rubble_drive& given) {
    return {readLiveHandle<HandleType::Body>(world.bodies(), given.body, "body"),
            readOrDefault(given.throttle, ranges::kLever, 0.0, "throttle"),
            readOrDefault(given.steer, ranges::kLever, 0.0, "steer"),
            readOrDefault(given.brake, ranges::kPedal, 0.0, "brake")};
}

GrabEdit readGrab(const World& world, const rubble_grab& given) {
    GrabEdit edit;
    edit.body = readLiveHandle<HandleType::Body>(world.bodies(), given.body, "body");
    edit.point = readVector(given.point, "point");
    edit.target = readVector(given.target, "target");
    edit.maxForce = readOrDefault(given.max_force, ranges::kForce, edit.maxForce, "max_force");
    edit.hertz = readOrDefault(given.spring_hertz, ranges::kGrabHertz, edit.hertz, "spring_hertz");
    edit.hand = uint32_t(readInRange(given.hand, ranges::kHand, "hand"));
    const uint32_t flags = readFlags(given.flags, RUBBLE_GRAB_TURNS | RUBBLE_GRAB_VELOCITY, "flags");
    edit.turns = flags & RUBBLE_GRAB_TURNS;
    edit.drives = flags & RUBBLE_GRAB_VELOCITY;
    if (edit.drives) edit.velocity = readVector(given.velocity, "velocity", ranges::kVelocity);
    if (!edit.turns) return edit;
    if (edit.drives) edit.angularVelocity = readVector(given.angular_velocity, "angular_velocity", ranges::kVelocity);
    edit.rotation = readRotation(given.rotation, "rotation");
    edit.maxTorque = readInRange(given.max_torque, ranges::kForce, "max_torque");
    return edit;
}

ReleaseEdit readRelease(const World&, const rubble_release& given) {
    return {readVector(given.impulse, "impulse", ranges::kImpulse),
            uint32_t(readInRange(given.hand, ranges::kHand, "hand"))};
}

ConstrainEdit readConstraint(const World& world, const rubble_body_constraint& given) {
    BodyConstraint out;
    out.turns = readEnum(given.kind, RUBBLE_CONSTRAINT_ANGULAR_VELOCITY, "kind") == RUBBLE_CONSTRAINT_ANGULAR_VELOCITY;
    out.body = readLiveHandle<HandleType::Body>(world.bodies(), given.body, "body");
    out.other = readOptionalHandle<HandleType::Body>(world.bodies(), given.other, "other");
    if (out.body == out.other) refuse(RUBBLE_ERROR_ARGUMENT, "other is the body itself, expected another one or 0");
    if (!out.turns) out.position = readVector(given.position, "position");
    out.direction = readDirection(given.direction, "direction");
    out.speed = readInRange(given.speed, ranges::kVelocity, "speed");
    out.minForce = readInRange(given.min_force, ranges::kConstraintForce, "min_force");
    out.maxForce = readInRange(given.max_force, ranges::kConstraintForce, "max_force");
    if (out.minForce > out.maxForce)
        refuse(RUBBLE_ERROR_ARGUMENT, "min_force is {:g}, expected at most max_force, {:g}", out.minForce,
               out.maxForce);
    return {out};
}

rubble_result addJoint(rubble_world world, const rubble_joint_settings* settings) {
    return pushEdit("add_joint", world, settings, "settings", readJoint);
}
rubble_result createJoint(rubble_world world, const rubble_joint_settings* settings, rubble_joint* out) {
    return pushMaker("create_joint", world, settings, out, &WorldObjects::joints, readJoint);
}
rubble_result removeJoint(rubble_world world, rubble_joint joint) {
    return removeOne<RemoveJointEdit, HandleType::Joint>("remove_joint", world, joint, "joint", &World::joints);
}
rubble_result setJointMotor(rubble_world world, const rubble_joint_motor* motor) {
    return pushEdit("set_joint_motor", world, motor, "motor", readJointMotor);
}
rubble_result driveWheels(rubble_world world, const rubble_drive* edit) {
    return pushMotionEdit("drive_wheels", world, edit, "drive", readDrive);
}
rubble_result grabBody(rubble_world world, const rubble_grab* edit) {
    return pushMotionEdit("grab_body", world, edit, "grab", readGrab);
}
rubble_result releaseBody(rubble_world world, const rubble_release* edit) {
    return pushMotionEdit("release_body", world, edit, "release", readRelease);
}

rubble_result constrainBodies(rubble_world world, const rubble_body_constraint* edit) {
    return pushMotionEdit("constrain_bodies", world, edit, "constraint", readConstraint);
}

rubble_joint_state jointState(const World& world, JointHandle handle, const Joint& joint) {
    rubble_joint_state state{};
    state.joint = handle.bits;
    state.kind = uint32_t(joint.kind);
    state.rope_point_count = uint32_t(joint.points.size());
    state.rope_length = joint.rope.length;
    for (size_t i = 0; i < 2; ++i) state.shapes[i] = joint.ends[i].shape.bits;
    writeVector(state.first_anchor, jointToWorld(world, joint.ends[0]).position);
    writeVector(state.second_anchor, jointToWorld(world, joint.ends[1]).position);
    return state;
}

rubble_result getJointStates(rubble_world world, rubble_joint_state* out, uint32_t capacity, uint32_t* count) {
    return listRows("get_joint_states", world, out, capacity, count);
}

rubble_result getJointState(rubble_world world, rubble_joint joint, rubble_joint_state* out) {
    return inWorld("get_joint_state", world, [&](const HostedWorld& hosted) {
        const World& inside = hosted.loop.world();
        const Joint* found = findLive<HandleType::Joint>(inside.joints(), joint, "joint");
        if (found && isGiven(out, "out")) *out = jointState(inside, JointHandle{joint}, *found);
    });
}

rubble_result getJointProperties(rubble_world world, rubble_joint joint, rubble_joint_properties* out) {
    return inWorld("get_joint_properties", world, [&](const HostedWorld& hosted) {
        const World& inside = hosted.loop.world();
        const Joint* found = findLive<HandleType::Joint>(inside.joints(), joint, "joint");
        if (!found) return;
        rubble_joint_properties values = {};
        values.kind = uint32_t(found->kind);
        if (found->collides) values.flags |= RUBBLE_JOINT_COLLIDES;
        if (found->limits.on) values.flags |= RUBBLE_JOINT_LIMITED;
        if (found->ends[0].isFree) values.flags |= RUBBLE_JOINT_FIRST_LOOSE;
        if (found->ends[1].isFree) values.flags |= RUBBLE_JOINT_SECOND_LOOSE;
        values.motor = uint32_t(found->motor.mode);
        values.motor_target = found->motor.target;
        values.motor_max_force = found->motor.maxForce;
        if (found->limits.on) values.lower_limit = found->limits.low, values.upper_limit = found->limits.high;
        values.spring_hertz = found->spring.hertz;
        values.spring_damping_ratio = found->spring.dampingRatio;
        values.friction = found->friction;
        values.break_force = found->breakForce;
        values.break_torque = found->breakTorque;
        values.steer_angle = found->steer;
        values.movement = jointMovement(inside.data(), *found);
        writeRotation(values.rotation, jointToWorld(inside, found->ends[0]).rotation);
        values.anchor_radius = found->ends[0].radius;
        if (found->kind == JointKind::Wheel) {
            const WheelSettings& wheel = found->wheel;
            values.drive_torque = wheel.driveTorque, values.brake_torque = wheel.brakeTorque;
            values.max_spin = wheel.maxSpin;
            values.max_steer_angle = wheel.steerAngle, values.steer_rate = wheel.steerRate;
        }
        writeStruct(out, values);
    });
}

rubble_result getRopePoints(rubble_world world, rubble_joint joint, double* out, uint32_t capacity, uint32_t* count) {
    return listRows<double>("get_rope_points", world, out, capacity, count, [&](const HostedWorld& hosted, auto& rows) {
        const Joint* rope = findLive<HandleType::Joint>(hosted.loop.world().joints(), joint, "joint");
        if (!rope) return;
        for (const RopePoint& point : rope->points)
            for (int i = 0; i < 3; ++i) rows.add([&] { return point.position[i]; });
    });
}

void addRope(RowWriter<rubble_rope_point>& rows, JointHandle handle, const Joint& rope) {
    for (const RopePoint& point : rope.points)
        rows.add([&] {
            rubble_rope_point row{};
            row.joint = handle.bits;
            writeVector(row.position, point.position);
            for (int i = 0; i < 3; ++i) row.velocity[i] = float(point.velocity[i]);
            row.radius = float(rope.rope.radius);
            std::copy(rope.rope.color.begin(), rope.rope.color.end(), row.color);
            row.is_last = &point == &rope.points.back();
            return row;
        });
}

rubble_result getRopes(rubble_world world, rubble_rope_point* out, uint32_t capacity, uint32_t* count) {
    const auto addRopes = [](const HostedWorld& hosted, RowWriter<rubble_rope_point>& rows) {
        hosted.loop.world().joints().forEach(
            [&](JointHandle handle, const Joint& joint) { addRope(rows, handle, joint); });
    };
    return listRows<rubble_rope_point>("get_ropes", world, out, capacity, count, addRopes);
}

}  // namespace

void writeRows(const HostedWorld& hosted, RowWriter<rubble_joint_state>& rows) {
    const World& inside = hosted.loop.world();
    inside.joints().forEach(
        [&](JointHandle handle, const Joint& joint) { rows.add([&] { return jointState(inside, handle, joint); }); });
}

void setJointFunctions(rubble_api& api) {
    api.add_joint = addJoint;
    api.create_joint = createJoint;
    api.remove_joint = removeJoint;
    api.set_joint_motor = setJointMotor;
    api.drive_wheels = driveWheels;
    api.grab_body = grabBody;
    api.release_body = releaseBody;
    api.constrain_bodies = constrainBodies;
    api.get_joint_states = getJointStates;
    api.get_joint_state = getJointState;
    api.get_joint_properties = getJointProperties;
    api.get_rope_points = getRopePoints;
    api.get_ropes = getRopes;
}

}  // namespace rubble::abi
