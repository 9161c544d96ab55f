#include "runtime/world/stages/rope_stage.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/constants.h"
#include "runtime/world/stages/joint_stage.h"

namespace rubble {
namespace {

constexpr double kSampleSpacing = 0.05;   ///< metres between the places of a rope that are tested for a cut
constexpr double kMinRopeLength = 0.3;    ///< metres to which a winch can wind a rope
constexpr double kWinchSpeed = 1.0;       ///< m/s while it winds to a target length
constexpr double kMaxWinchSpeed = 100.0;  ///< m/s of a speed motor
constexpr double kMaxRopeLength = 1e4;    ///< metres to which a winch can unwind a rope
constexpr double kMinPartLength = 0.02;   ///< metres: a shorter part of a cut rope vanishes

/// Whether a place is inside the volume that an edit takes out of soft materials.
bool isInside(const CarveEdit& volume, glm::dvec3 place) {
    const double radius = std::max({volume.radii[0], volume.radii[1], volume.radii[2]});
    glm::dvec3 away = place - volume.position;
    if (volume.kind == BrushKind::Box) {
        const glm::dvec3 local = glm::conjugate(volume.rotation) * away;
        return std::abs(local.x) <= volume.halfSize.x && std::abs(local.y) <= volume.halfSize.y &&
               std::abs(local.z) <= volume.halfSize.z;
    }
    if (volume.kind == BrushKind::Capsule) {
        const glm::dvec3 segment = volume.end - volume.position;
        const double length2 = glm::dot(segment, segment);
        if (length2 > 0.0) away -= segment * std::clamp(glm::dot(away, segment) / length2, 0.0, 1.0);
    }
    return glm::dot(away, away) <= radius * radius;
}

}  // namespace

void cutRopes(EditContext& context, const CarveEdit& volume) {
    for (const JointHandle handle : copyOf(context.world.jointIndex.ropes())) {
        const Joint& rope = context.world.joints.at(handle);
        double first = -1.0, last = -1.0;
        bool isPast = false;
        for (size_t i = 0; i + 1 < rope.points.size() && !isPast; ++i) {
            const glm::dvec3 from = rope.points[i].position, segment = rope.points[i + 1].position - from;
            const int samples = int(std::clamp(std::ceil(glm::length(segment) / kSampleSpacing), 1.0, 1000.0));
            for (int k = 0; k < samples && !isPast; ++k) {
                const double along = double(k) / samples;
                const bool isCut = isInside(volume, from + segment * along);
                if (isCut && first < 0.0) first = double(i) + along;
                if (isCut) last = double(i) + along;
                isPast = first >= 0.0 && !isCut;
            }
        }
        if (first >= 0.0) cutRope(context, handle, 0.5 * (first + last), JointBreak::Cut);
    }
}

bool cutRope(EditContext& context, JointHandle handle, double place, JointBreak reason) {
    const Joint rope = context.world.joints.at(handle);
    const size_t last = rope.points.size() - 1;
    const size_t before = std::min(size_t(std::max(place, 0.0)), last - 1);
    const double along = std::clamp(place - double(before), 0.0, 1.0), spacing = rope.rope.length / double(last);
    const RopePoint &from = rope.points[before], &to = rope.points[before + 1];
    const RopePoint cut{from.position + (to.position - from.position) * along,
                        from.velocity + (to.velocity - from.velocity) * along};
    Joint first = rope, second = rope;
    first.points.assign(rope.points.begin(), rope.points.begin() + ptrdiff_t(before) + 1);
    first.points.push_back(cut);
    second.points.assign(rope.points.begin() + ptrdiff_t(before), rope.points.end());
    second.points.front() = cut;
    first.rope.length = spacing * (double(before) + along);
    second.rope.length = spacing * (double(last - before) - along);
    first.ends[1] = second.ends[0] = {.frame = {cut.position}, .isFree = true};
    std::vector<Joint> parts;
    for (Joint* part : {&first, &second}) {
        part->rope.points = uint32_t(part->points.size());
        part->motor = {};
        const bool hangs = !part->ends[0].isFree || !part->ends[1].isFree;
        if (hangs && part->rope.length >= kMinPartLength) parts.push_back(std::move(*part));
    }
    if (parts.empty()) return false;
    context.changes.jointsBroken.push_back({handle, reason, cut.position});
    context.world.jointIndex.remove(handle, rope);
    context.world.joints.at(handle) = std::move(parts[0]);
    context.world.jointIndex.add(handle, context.world.joints.at(handle));
    context.changes.jointsChanged.push_back(handle);
    if (parts.size() > 1) context.changes.jointsCreated.push_back(context.world.addJoint(std::move(parts[1])));
    return true;
}

void updateWinches(EditContext& context) {
    for (const JointHandle handle : context.world.jointIndex.winding()) {
        Joint& rope = context.world.joints.at(handle);
        const double maxChange = kWinchSpeed / kStepsPerSecond;
        const double change = rope.motor.mode == MotorMode::Speed
                                  ? std::clamp(rope.motor.target, -kMaxWinchSpeed, kMaxWinchSpeed) / kStepsPerSecond
                                  : std::clamp(rope.motor.target - rope.rope.length, -maxChange, maxChange);
        const double length =
            std::clamp(rope.rope.length + change, std::min(kMinRopeLength, rope.rope.length), kMaxRopeLength);
        if (length == rope.rope.length) continue;
        rope.rope.length = length;
        context.changes.jointsChanged.push_back(handle);
    }
}

}  // namespace rubble
