#pragma once
#include <rubble/rubble.hpp>

namespace editor {

/// Whether a joint may have another frame: a rope has two ends, a wheel belongs to its vehicle.
bool hasFrame(const rubble::World& world, rubble_joint joint);
/// A joint with a frame as create_joint() takes it. Its limits and target are those from the pose in which its shapes
/// are now.
rubble_joint_settings settingsOf(const rubble::World& world, rubble_joint joint);
/// Makes a joint again with other settings, as an edit: with its name and tags, but with another handle.
rubble_joint remakeJoint(rubble::World& world, rubble_joint joint, const rubble_joint_settings& settings);

}  // namespace editor
