#pragma once
#include "runtime/plugin/include/rubble/rubble.h"
#include "runtime/world/world.h"

namespace rubble::abi {

// The host's joints as the World's, checked. Throw ApiError.
AddJointEdit toEdit(const World& world, const rubble_joint_settings& settings);
SetJointMotorEdit toEdit(const World& world, const rubble_joint_motor& motor);
DriveEdit toEdit(const World& world, const rubble_drive& drive);
GrabEdit toEdit(const World& world, const rubble_grab& grab);
ReleaseEdit toEdit(const World& world, const rubble_release& release);
/// Throws if the handle is stale.
const Joint& jointOf(const World& world, rubble_joint joint);
rubble_joint_state jointState(const World& world, JointHandle handle, const Joint& joint);

}  // namespace rubble::abi
