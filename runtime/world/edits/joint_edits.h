#pragma once
#include "runtime/world/objects/joint.h"

namespace rubble {

/// Makes a joint; FrameChanges::jointsCreated names it. Refused, with a line in the log, where an end has no voxel to
/// hold on to.
struct AddJointEdit {
    Joint joint;
};

/// Removes or breaks a joint: the reason is what FrameChanges::jointsBroken says. A rope that is Cut parts at `place`,
/// else it goes.
struct RemoveJointEdit {
    JointHandle joint;
    JointBreak reason = JointBreak::Removed;
    glm::dvec3 place{0.0};  ///< world
};

/// Sets what drives and brakes a joint, and wakes what it holds.
struct SetJointMotorEdit {
    JointHandle joint;
    JointMotor motor;
    double friction = 0.0;
    double steer = 0.0;
};

/// Drives a vehicle: any body that has wheels (JointKind::Wheel) at its end 0. Each wheel does what its WheelSettings
/// let it; what broke off takes its wheels along, and they are driven no more. Holds until the next one.
struct DriveEdit {
    BodyHandle body;
    double throttle = 0.0;  ///< -1 (back) to 1
    double steer = 0.0;     ///< -1 (right) to 1
    double brake = 0.0;     ///< 0 to 1
};

/// Lets a rope's end on a shape go loose. Other joints are removed.
struct DetachJointEdit {
    JointHandle joint;
    ShapeHandle shape;
};

/// Pulls a body by a point toward a place, with no more than a force. A hand holds one body: grabbing the same one
/// again moves the place, another one lets go of the first.
struct GrabEdit {
    BodyHandle body;
    glm::dvec3 point{0.0};   ///< world; where it is taken hold of, counts when it is
    glm::dvec3 target{0.0};  ///< world
    double maxForce = 1000.0;
    double hertz = 4.0;
    uint32_t hand = 0;
};

/// Lets go of what a hand holds, and throws it.
struct ReleaseEdit {
    glm::dvec3 impulse{0.0};  ///< N s, where it was held
    uint32_t hand = 0;
};

}  // namespace rubble
