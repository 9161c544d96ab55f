#include "runtime/world/objects/joint_attachment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "runtime/core/ranges.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/nearest_voxel.h"
#include "runtime/world/objects/transforms.h"

namespace rubble {
namespace {

constexpr double kRopeSpacing = 0.4;    ///< metres between a rope's points, unless it sets their number
constexpr double kMinRopePoints = 9.0;  ///< of those: fewer cannot go round the body at an end, and swing through it
constexpr int kMaxSearchCells = 32;     ///< around an end, in which its voxel is searched

/// The cell that holds a joint's end: the nearest voxel within `radius`, both in cells.
std::optional<glm::ivec3> findHeldCell(const VoxelGrid& grid, glm::dvec3 point, double radius) {
    const glm::dvec3 inside =
        glm::clamp(point, glm::dvec3(-kMaxSearchCells), glm::dvec3(grid.size() + kMaxSearchCells));
    const glm::ivec3 middle = cellAt(inside);
    const int r = int(std::min(std::ceil(radius), double(kMaxSearchCells)));
    const double limit = radius + 0.9;  // half the diagonal of a cell more: a surface's own voxels count
    return nearestVoxel(grid, point, {middle - r, middle + r + 1}, limit * limit);
}

/// Points on a straight line from end to end. A longer rope sags by itself.
void initRopePoints(Joint& joint, glm::dvec3 from, glm::dvec3 to) {
    RopeSettings& rope = joint.rope;
    if (rope.length == 0.0) rope.length = glm::length(to - from) + rope.slack;
    rope.length = std::clamp(rope.length, 0.01, ranges::kJointNumber.high);
    if (rope.points == 0)
        rope.points =
            uint32_t(std::clamp(std::round(rope.length / kRopeSpacing) + 1.0, kMinRopePoints, double(kMaxRopePoints)));
    if (joint.points.size() == rope.points) return;
    joint.points.resize(rope.points);
    for (uint32_t i = 0; i < rope.points; ++i)
        joint.points[i].position = from + (to - from) * (double(i) / double(rope.points - 1));
}

/// But for rounding: what was normalized once stays as it is, so that loading a level twice gives the same bits.
bool isUnit(const glm::dquat& rotation) {
    return std::abs(glm::dot(rotation, rotation) - 1.0) < 1e-14;
}

}  // namespace

std::string jointBodiesError(JointKind kind, const Shape* first, const Shape* second) {
    if (kind == JointKind::Rope || !first || !second || first->body != second->body) return "";
    return "both ends are on one body; a joint joins two bodies, or a body and the world";
}

std::string attachJoint(const WorldObjects& objects, Joint& joint) {
    if (std::string error = jointError(joint); !error.empty()) return error;
    if (std::string error = jointEndsError(joint); !error.empty()) return error;
    if (std::string error = jointBodiesError(joint.kind, objects.shapes.find(joint.ends[0].shape),
                                             objects.shapes.find(joint.ends[1].shape));
        !error.empty())
        return error;
    for (JointEnd& end : joint.ends) {
        if (!isUnit(end.frame.rotation)) end.frame.rotation = glm::normalize(end.frame.rotation);
        if (!end.shape) continue;
        const Shape* shape = objects.shapes.find(end.shape);
        if (!shape) return "the handle of a shape is stale";
        if (end.cell.x >= 0 && shape->grid.at(end.cell)) continue;
        const double cells = 1.0 / double(shape->voxelSize);
        const std::optional<glm::ivec3> cell =
            findHeldCell(shape->grid, end.frame.position * cells, end.radius * cells);
        if (!cell) return "no voxel to hold on to within the radius of an end";
        end.cell = *cell;
    }
    joint.steerTarget = joint.steer;
    if (joint.kind == JointKind::Rope)
        initRopePoints(joint, jointToWorld(objects, joint.ends[0]).position,
                       jointToWorld(objects, joint.ends[1]).position);
    return "";
}

void placeEnd(const WorldObjects& objects, JointEnd& end) {
    if (!objects.shapes.find(end.shape)) return;
    const Pose pose = shapeToWorld(objects, end.shape);
    end.frame = {pose.inversePoint(end.frame.position), glm::conjugate(pose.rotation) * end.frame.rotation};
}

Joint jointAt(const WorldObjects& objects, JointKind kind, ShapeHandle first, ShapeHandle second, const Pose& frame) {
    Joint joint{.kind = kind};
    const std::array<ShapeHandle, 2> shapes = {first, second};
    for (size_t i = 0; i < 2; ++i) {
        joint.ends[i].shape = shapes[i];
        joint.ends[i].frame = frame;
        placeEnd(objects, joint.ends[i]);
    }
    return joint;
}

}  // namespace rubble
