#include "runtime/world/stages/drive_edits.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/constants.h"
#include "runtime/core/log.h"
#include "runtime/core/ranges.h"

namespace rubble {
namespace {

constexpr double kStep = 1.0 / kStepsPerSecond;  ///< s
constexpr double kReverseSpeedShare = 0.5;       ///< top speed backward, as a share of that forward
constexpr double kRollingResistance = 0.01;      ///< share of a wheel's larger torque that always holds against rolling
constexpr double kMinThrottle = 0.004;           ///< below this the motor is out of gear

/// The wheel with motor, brake and steering as the edit sets them for this step.
Joint drivenWheel(const Joint& wheel, const DriveEdit& drive) {
    Joint out = wheel;
    const WheelSettings& settings = wheel.wheel;
    const double throttle = std::abs(drive.throttle) < kMinThrottle ? 0.0 : drive.throttle;
    const bool isOn = throttle != 0.0 && settings.driveTorque > 0.0;
    out.motor.mode = isOn ? MotorMode::Speed : MotorMode::Off;
    out.motor.target = isOn ? (throttle > 0.0 ? settings.maxSpin : -kReverseSpeedShare * settings.maxSpin) : 0.0;
    out.motor.maxForce = isOn ? std::abs(throttle) * settings.driveTorque : 0.0;
    out.friction = std::min(
        drive.brake * settings.brakeTorque + kRollingResistance * std::max(settings.driveTorque, settings.brakeTorque),
        ranges::kJointNumber.high);
    const double turn = settings.steerRate * kStep;
    out.steer += std::clamp(drive.steer * settings.steerAngle - wheel.steer, -turn, turn);
    return out;
}

}  // namespace

void apply(EditContext& context, const DriveEdit& edit) {
    const Body* body = context.world.bodies.find(edit.body);
    if (!body) return logWarning("drive_wheels: the handle of its body is stale; nothing was driven");
    for (const ShapeHandle shape : body->shapes)
        for (const JointHandle handle : context.world.jointIndex.of(shape)) {
            Joint& joint = context.world.joints.at(handle);
            if (joint.kind != JointKind::Wheel || joint.ends[0].shape != shape) continue;
            Joint wheel = drivenWheel(joint, edit);
            const bool isSame = wheel.motor.mode == joint.motor.mode && wheel.motor.target == joint.motor.target &&
                                wheel.motor.maxForce == joint.motor.maxForce && wheel.friction == joint.friction &&
                                wheel.steer == joint.steer;
            if (isSame) continue;
            joint = std::move(wheel);
            context.changes.jointsChanged.push_back(handle);
        }
}

}  // namespace rubble
