#include <algorithm>

#include "runtime/core/log.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {
namespace {

constexpr double kStep = 1.0 / 60.0;
constexpr double kReverseSpeedShare = 0.5;  ///< of the top speed, backward
constexpr double kRollingResistance =
    0.01;  ///< of a wheel's torques, that hold against its rolling when nothing drives or brakes it
constexpr double kMinThrottle = 0.004;  ///< throttle below which the motor is out of gear

bool isWithinUnit(double value, double low) {
    return value >= low && value <= 1.0;
}

/// What a wheel does in this step.
Joint drivenWheel(const Joint& wheel, const DriveEdit& drive) {
    Joint out = wheel;
    const WheelSettings& settings = wheel.wheel;
    const double throttle = std::abs(drive.throttle) < kMinThrottle ? 0.0 : drive.throttle;
    const bool isOn = throttle != 0.0 && settings.driveTorque > 0.0;
    out.motor.mode = isOn ? MotorMode::Speed : MotorMode::Off;
    out.motor.target = isOn ? (throttle > 0.0 ? settings.topSpin : -kReverseSpeedShare * settings.topSpin) : 0.0;
    out.motor.maxForce = isOn ? std::abs(throttle) * settings.driveTorque : 0.0;
    out.friction =
        drive.brake * settings.brakeTorque + kRollingResistance * std::max(settings.driveTorque, settings.brakeTorque);
    const double turn = settings.steerRate * kStep;
    out.steer += std::clamp(drive.steer * settings.steerAngle - wheel.steer, -turn, turn);
    return out;
}

}  // namespace

void EditStep::apply(const DriveEdit& edit) {
    const Body* body = m_world.m_bodies.find(edit.body);
    if (!body) return logWarning("DriveEdit: the handle of its body is stale; nothing was drivenWheel");
    if (!isWithinUnit(edit.throttle, -1.0) || !isWithinUnit(edit.steer, -1.0) || !isWithinUnit(edit.brake, 0.0))
        return logWarning("DriveEdit: throttle and steer go from -1 to 1, brake from 0 to 1; nothing was drivenWheel");
    for (const ShapeHandle shape : body->shapes)
        for (const JointHandle handle : m_world.jointsOf(shape)) {
            Joint& joint = m_world.m_joints.at(handle);
            if (joint.kind != JointKind::Wheel || joint.ends[0].shape != shape) continue;
            Joint wheel = drivenWheel(joint, edit);
            const bool isSame = wheel.motor.mode == joint.motor.mode && wheel.motor.target == joint.motor.target &&
                                wheel.motor.maxForce == joint.motor.maxForce && wheel.friction == joint.friction &&
                                wheel.steer == joint.steer;
            if (isSame) continue;
            joint = std::move(wheel);
            m_changes.jointsChanged.push_back(handle);
        }
}

}  // namespace rubble
