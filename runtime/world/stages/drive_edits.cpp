#include "runtime/world/stages/drive_edits.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/angles.h"
#include "runtime/core/constants.h"
#include "runtime/core/log.h"
#include "runtime/core/ranges.h"
#include "runtime/world/stages/joint_stage.h"

namespace rubble {
namespace {

constexpr double kStep = 1.0 / kStepsPerSecond;  ///< s
constexpr double kReverseSpeedShare = 0.5;       ///< top speed backward, as a share of that forward
constexpr double kRollingResistance = 0.01;      ///< share of a wheel's larger torque that always holds against rolling
constexpr double kMinThrottle = 0.004;           ///< below this the motor is out of gear

/// The vehicle's axes and its wheels, in the body's frame: what turns it.
class SteeringGeometry {
public:
    /// Adds a wheel whose place and axes are those of end 0's frame.
    void add(const WheelSettings& wheel, const Pose& frame) {
        if (m_wheels++ == 0) m_axes = frame.rotation;
        const glm::dvec3 place = glm::conjugate(m_axes) * frame.position;
        const bool isAligned = std::abs(glm::dot(m_axes, frame.rotation)) > kMinAlignment;
        m_isRegular = m_isRegular && isAligned;
        if (wheel.steerAngle == 0.0) return m_fixed.add(place);
        m_isRegular = m_isRegular && (m_steered.count == 0 || m_steerAngle == wheel.steerAngle);
        m_steerAngle = wheel.steerAngle;
        m_steered.add(place);
    }
    /// The angle of a steered wheel, radians, if the middle of the steered ones turns by `angle`: all wheels' axles
    /// meet in one point of the fixed ones' line (Ackermann). The same angle where the wheels have no such point.
    double angleOf(const Pose& frame, double angle) const {
        if (!m_isRegular || m_fixed.count == 0 || m_steered.count < 2 || angle == 0.0) return angle;
        const double base = m_steered.mean().z - m_fixed.mean().z, side = base < 0.0 ? -1.0 : 1.0;
        if (std::abs(base) < kMinBase) return angle;
        const glm::dvec3 place = glm::conjugate(m_axes) * frame.position;
        double cosine, sine;
        deterministicCosSin(angle, cosine, sine);
        const double ahead = (place.z - m_fixed.mean().z) * side, aside = place.x - m_steered.mean().x;
        // The turning centre is base / tan(angle) to the left of the middle.
        return deterministicAtan2(ahead * sine,
                                  std::max(base * side * cosine - aside * side * sine, kMinReach * ahead));
    }

private:
    static constexpr double kMinAlignment = 0.9999;  ///< half the angle between frames, as its cosine
    static constexpr double kMinBase = 0.1;          ///< metres from the fixed wheels to the steered ones
    static constexpr double kMinReach = 0.07;        ///< of a wheel's distance ahead, that the centre is beside it
    struct Wheels {
        glm::dvec3 sum{0.0};
        int count = 0;
        void add(const glm::dvec3& place) { sum += place, ++count; }
        glm::dvec3 mean() const { return sum / double(count); }
    };
    glm::dquat m_axes{1, 0, 0, 0};  ///< x left, y up, z forward
    Wheels m_fixed, m_steered;
    int m_wheels = 0;
    double m_steerAngle = 0.0;
    bool m_isRegular = true;  ///< all stand in one direction, and those that steer turn by the same angle
};

/// Calls f(handle, frame) for the wheels of a body; frame: of end 0, in the body's frame.
template <class F>
void forEachWheel(EditContext& context, const Body& body, F&& f) {
    for (const ShapeHandle shape : body.shapes)
        for (const JointHandle handle : context.world.jointIndex.of(shape)) {
            const Joint& joint = context.world.joints.at(handle);
            if (joint.kind == JointKind::Wheel && joint.ends[0].shape == shape)
                f(handle, context.world.shapes.at(shape).local * joint.ends[0].frame);
        }
}

/// The wheel with motor, brake and steering as the edit sets them. steer: radians that it turns to.
Joint drivenWheel(const Joint& wheel, const DriveEdit& drive, double steer) {
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
    out.steerTarget = steer;
    return out;
}

}  // namespace

void apply(EditContext& context, const DriveEdit& edit) {
    const Body* body = context.world.bodies.find(edit.body);
    if (!body) return context.warnStale("drive_wheels: the handle of its body is stale; nothing was driven");
    SteeringGeometry geometry;
    forEachWheel(context, *body, [&](JointHandle handle, const Pose& frame) {
        geometry.add(context.world.joints.at(handle).wheel, frame);
    });
    forEachWheel(context, *body, [&](JointHandle handle, const Pose& frame) {
        Joint& joint = context.world.joints.at(handle);
        const double steer = edit.steer * joint.wheel.steerAngle;
        Joint wheel = drivenWheel(joint, edit, steer == 0.0 ? 0.0 : geometry.angleOf(frame, steer));
        const bool isSame = wheel.motor.mode == joint.motor.mode && wheel.motor.target == joint.motor.target &&
                            wheel.motor.maxForce == joint.motor.maxForce && wheel.friction == joint.friction &&
                            wheel.steerTarget == joint.steerTarget;
        if (isSame) return;
        joint = std::move(wheel);
        context.world.jointIndex.updateDrive(handle, joint);
        context.changes.jointsChanged.push_back(handle);
    });
}

void updateSteering(EditContext& context) {
    for (const JointHandle handle : copyOf(context.world.jointIndex.turning())) {
        Joint& wheel = context.world.joints.at(handle);
        const double turn = wheel.wheel.steerRate * kStep;
        const double left = wheel.steerTarget - wheel.steer;
        wheel.steer =
            std::abs(left) <= turn * (1.0 + 1e-9) ? wheel.steerTarget : wheel.steer + std::copysign(turn, left);
        context.world.jointIndex.updateDrive(handle, wheel);
        context.changes.jointsChanged.push_back(handle);
    }
}

}  // namespace rubble
