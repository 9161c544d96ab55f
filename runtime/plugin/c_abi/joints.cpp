#include "runtime/plugin/c_abi/joints.h"

#include "runtime/plugin/c_abi/checks.h"

namespace rubble::abi {
namespace {

constexpr double kMaxMagnitude = 1e12;

double readSize(double value, const char* name) {
    return readOrDefault(value, 0.0, kMaxMagnitude, 0.0, name);
}

JointMotor readMotor(uint32_t mode, double target, double force) {
    if (mode > RUBBLE_MOTOR_POSITION)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "motor is " + std::to_string(mode) + ", expected 0 to 2"};
    return {MotorMode(mode), readOrDefault(target, -kMaxMagnitude, kMaxMagnitude, 0.0, "motor_target"),
            readSize(force, "motor_max_force")};
}

}  // namespace

AddJointEdit toEdit(const World& world, const rubble_joint_settings& given) {
    if (given.kind > RUBBLE_JOINT_WHEEL)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "kind is " + std::to_string(given.kind) + ", expected 0 to 6"};
    std::array<ShapeHandle, 2> shapes;
    for (size_t i = 0; i < 2; ++i) {
        shapes[i] = readHandle<HandleType::Shape>(given.shapes[i], "shapes");
        if (shapes[i] && !world.shapes().find(shapes[i]))
            throw ApiError{RUBBLE_ERROR_STALE, "shapes: a shape is stale"};
    }
    const JointKind kind = JointKind(given.kind);
    const Pose frame{readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    Joint joint = jointAt(world, kind, shapes[0], shapes[1], frame);
    if (kind == JointKind::Rope)
        joint.ends[1] = jointAt(world, kind, {}, shapes[1], {readVector(given.rope_end, "rope_end")}).ends[1];
    const double radius = readOrDefault(given.radius, 0.0, 100.0, joint.ends[0].radius, "radius");
    joint.ends[0].radius = joint.ends[1].radius = radius;
    joint.collides = given.flags & RUBBLE_JOINT_COLLIDES;
    joint.limits = {(given.flags & RUBBLE_JOINT_LIMITED) != 0,
                    readOrDefault(given.low, -kMaxMagnitude, kMaxMagnitude, 0.0, "low"),
                    readOrDefault(given.high, -kMaxMagnitude, kMaxMagnitude, 0.0, "high")};
    joint.motor = readMotor(given.motor, given.motor_target, given.motor_max_force);
    joint.spring = {readSize(given.spring_hertz, "spring_hertz"),
                    readSize(given.spring_damping_ratio, "spring_damping_ratio")};
    joint.friction = readSize(given.friction, "friction");
    joint.breakForce = readSize(given.break_force, "break_force");
    joint.breakTorque = readSize(given.break_torque, "break_torque");
    joint.rope.length = readSize(given.rope_length, "rope_length");
    joint.rope.radius = readOrDefault(given.rope_radius, 1e-3, 1.0, joint.rope.radius, "rope_radius");
    joint.rope.stretch = readSize(given.rope_stretch, "rope_stretch");
    joint.rope.strength = readSize(given.rope_strength, "rope_strength");
    joint.wheel = {readSize(given.drive_torque, "drive_torque"),
                   readOrDefault(given.max_spin, 0.0, 1e4, joint.wheel.topSpin, "max_spin"),
                   readSize(given.brake_torque, "brake_torque"),
                   readOrDefault(given.max_steer_angle, 0.0, 1.5, 0.0, "max_steer_angle"),
                   readOrDefault(given.steer_rate, 0.0, 100.0, joint.wheel.steerRate, "steer_rate")};
    requireNoError(jointError(joint));
    return {joint};
}

SetJointMotorEdit toEdit(const World& world, const rubble_joint_motor& given) {
    jointOf(world, given.joint);
    return {JointHandle{given.joint}, readMotor(given.motor, given.motor_target, given.motor_max_force),
            readSize(given.friction, "friction"), readOrDefault(given.steer, -3.0, 3.0, 0.0, "steer")};
}

DriveEdit toEdit(const World& world, const rubble_drive& given) {
    const BodyHandle body = readHandle<HandleType::Body>(given.body, "body");
    if (!world.bodies().find(body)) throw ApiError{RUBBLE_ERROR_STALE, "body is stale"};
    return {body, readOrDefault(given.throttle, -1.0, 1.0, 0.0, "throttle"),
            readOrDefault(given.steer, -1.0, 1.0, 0.0, "steer"), readOrDefault(given.brake, 0.0, 1.0, 0.0, "brake")};
}

GrabEdit toEdit(const World& world, const rubble_grab& given) {
    GrabEdit edit;
    edit.body = readHandle<HandleType::Body>(given.body, "body");
    if (!world.bodies().find(edit.body)) throw ApiError{RUBBLE_ERROR_STALE, "body is stale"};
    edit.point = readVector(given.point, "point");
    edit.target = readVector(given.target, "target");
    edit.maxForce = readOrDefault(given.force, 0.0, 1e9, edit.maxForce, "force");
    edit.hertz = readOrDefault(given.hertz, 0.1, 60.0, edit.hertz, "hertz");
    edit.hand = given.hand;
    return edit;
}

ReleaseEdit toEdit(const World&, const rubble_release& given) {
    return {readVector(given.impulse, "impulse"), given.hand};
}

const Joint& jointOf(const World& world, rubble_joint bits) {
    const Joint* joint = world.joints().find(readHandle<HandleType::Joint>(bits, "joint"));
    if (!joint) throw ApiError{RUBBLE_ERROR_STALE, bits ? "joint is stale" : "joint is 0"};
    return *joint;
}

rubble_joint_state jointState(const World& world, JointHandle handle, const Joint& joint) {
    rubble_joint_state state{};
    state.joint = handle.bits;
    state.kind = uint32_t(joint.kind);
    state.rope_points = uint32_t(joint.points.size());
    state.rope_length = joint.rope.length;
    for (size_t i = 0; i < 2; ++i) state.shapes[i] = joint.ends[i].shape.bits;
    writeVector(state.first, world.jointToWorld(joint.ends[0]).position);
    writeVector(state.second, world.jointToWorld(joint.ends[1]).position);
    return state;
}

}  // namespace rubble::abi
