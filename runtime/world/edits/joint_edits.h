#pragma once
#include "runtime/world/objects/body_constraint.h"
#include "runtime/world/objects/joint.h"

namespace rubble {

/// Makes a joint; FrameChanges::jointsCreated names it. Refused, and logged, if an end has no voxel to hold on to.
struct AddJointEdit {
    Joint joint;
    bool inWorld = false;  ///< the frames of its ends are in the world: the step finds where that is in their shapes
};

/// Removes or breaks a joint; FrameChanges::jointsBroken gets the reason. A rope that is cut parts at its point nearest
/// to `place`, one that breaks by force parts in the middle.
struct RemoveJointEdit {
    JointHandle joint;
    JointBreak reason = JointBreak::Removed;
    glm::dvec3 place{0.0};  ///< world
};

/// Sets what drives and brakes a joint, and wakes the bodies that it joins.
struct SetJointMotorEdit {
    JointHandle joint;
    JointMotor motor;
    double friction = 0.0;  ///< see Joint::friction
    double steer = 0.0;     ///< see Joint::steer
};

/// Drives a vehicle: any body that is end 0 of wheels (JointKind::Wheel). Each wheel follows within its WheelSettings.
/// Wheels on a part that broke off are no longer driven. Holds until the next DriveEdit.
struct DriveEdit {
    BodyHandle body;
    double throttle = 0.0;  ///< -1 (back) to 1
    double steer = 0.0;     ///< -1 (right) to 1
    double brake = 0.0;     ///< 0 to 1
};

/// Frees a rope's end from a shape. Joints of other kinds are removed, and a rope that nothing holds any more.
struct DetachJointEdit {
    JointHandle joint;
    ShapeHandle shape;
};

/// Pulls a body by a point toward a target or at a velocity with a limited force, and may turn it. A hand holds one
/// body: grabbing the same one again moves the target, grabbing another one releases the first.
struct GrabEdit {
    BodyHandle body;
    glm::dvec3 point{0.0};     ///< world; where it is held: read when the grab begins
    glm::dvec3 target{0.0};    ///< world
    double maxForce = 1000.0;  ///< N
    double hertz = 4.0;        ///< of the spring that pulls
    uint32_t hand = 0;         ///< which hand; each holds one body
    bool turns = false;        ///< it turns the body's frame toward `rotation` too; else the body hangs at the point
    glm::dquat rotation{1, 0, 0, 0};  ///< world
    double maxTorque = 0.0;           ///< N m; 0: no limit
    /// It holds the point at `velocity`, and turns the body at `angularVelocity` if it turns it: not at their places.
    bool drives = false;
    glm::dvec3 velocity{0.0};         ///< m/s, world
    glm::dvec3 angularVelocity{0.0};  ///< rad/s, world axes
};

/// Constrains bodies in the next step of physics.
struct ConstrainEdit {
    BodyConstraint constraint;
};

/// Releases what a hand holds, with a push.
struct ReleaseEdit {
    glm::dvec3 impulse{0.0};  ///< N s, where it was held
    uint32_t hand = 0;
};

}  // namespace rubble
