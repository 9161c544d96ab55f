#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <rubble/rubble.hpp>
#include <vector>

namespace editor {

/// Whether a joint may have another frame: a rope has two ends, and the axle of a wheel that is steered now is not that
/// of its frame.
bool hasFrame(const rubble::World& world, rubble_joint joint);
/// Whether the limits of a joint are metres: of one that slides, and of a wheel's suspension. Else they are radians.
bool isLimitedInMetres(uint32_t kind);
/// The frame of a wheel whose axle points along an axis, to the left of who drives, and whose suspension is as near to
/// a direction as can be. None: the axis is along it, or 0.
std::optional<glm::dquat> wheelFrame(glm::dvec3 axis, glm::dvec3 up);
/// A joint with a frame as create_joint() takes it. Its limits and target are those from the pose in which its shapes
/// are now, and a wheel's suspension rests there.
rubble_joint_settings settingsOf(const rubble::World& world, rubble_joint joint);
/// All that a joint is, but for its handle.
struct JointCopy {
    rubble_joint_settings settings{};  ///< as settingsOf() gives them
    std::vector<char> name, tags;      ///< as rubble.hpp gives them
};
/// That of a joint that hasFrame().
JointCopy copyOf(const rubble::World& world, rubble_joint joint);
/// Gives a joint its name and tags.
void nameJoint(rubble::World& world, rubble_joint joint, const JointCopy& copy);
/// Gives an object tags, as get_tags() of rubble.hpp lists them.
void setTags(rubble::World& world, uint64_t object, const std::vector<char>& tags);
/// Makes a joint again with other settings, as an edit: with its name and tags, but with another handle.
rubble_joint remakeJoint(rubble::World& world, rubble_joint joint, const rubble_joint_settings& settings);

}  // namespace editor
