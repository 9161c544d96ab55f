#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <set>

#include "runtime/world/history/undo_history.h"
#include "runtime/world/world.h"
#include "runtime/world/history/world_delta.h"

namespace rubble {
namespace {

constexpr double kRopeSpacing = 0.4;  ///< metres between a rope's points, if it does not say
constexpr int kMaxSearchCells = 32;   ///< cells around an end in which its voxel is looked for

/// The solid cell whose middle is nearest to a point within `radius`, both in cells; the first in the order of cells of
/// those as near.
std::optional<glm::ivec3> nearestSolidCell(const VoxelGrid& grid, glm::dvec3 point, double radius) {
    const glm::dvec3 inside =
        glm::clamp(point, glm::dvec3(-kMaxSearchCells), glm::dvec3(grid.size() + kMaxSearchCells));
    const glm::ivec3 middle = glm::ivec3(glm::floor(inside));
    const int r = int(std::min(std::ceil(radius), double(kMaxSearchCells)));
    const glm::ivec3 low = glm::max(middle - r, 0), high = glm::min(middle + r, grid.size() - 1);
    std::optional<glm::ivec3> best;
    double nearest = (radius + 0.9) * (radius + 0.9);  // half the diagonal of a cell more: a surface's own voxels count
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                const glm::dvec3 offset = glm::dvec3(x, y, z) + 0.5 - point;
                const double distance = glm::dot(offset, offset);
                if (distance < nearest && grid.at({x, y, z})) best = {x, y, z}, nearest = distance;
            }
    return best;
}

/// A straight line of points from end to end: what is longer sags by itself.
void initRopePoints(Joint& joint, glm::dvec3 from, glm::dvec3 to) {
    RopeSettings& rope = joint.rope;
    if (rope.length == 0.0) rope.length = glm::length(to - from) + rope.slack;
    rope.length = std::max(rope.length, 0.01);
    if (rope.points == 0)
        rope.points = uint32_t(std::clamp(std::round(rope.length / kRopeSpacing) + 1.0, 3.0, double(kMaxRopePoints)));
    if (joint.points.size() == rope.points) return;
    joint.points.resize(rope.points);
    for (uint32_t i = 0; i < rope.points; ++i)
        joint.points[i].position = from + (to - from) * (double(i) / double(rope.points - 1));
}

}  // namespace

std::string World::resolveJoint(Joint& joint) const {
    if (std::string error = jointError(joint); !error.empty()) return error;
    if (joint.kind != JointKind::Rope && !joint.ends[0].shape && !joint.ends[1].shape)
        return "neither end is on a shape";
    for (JointEnd& end : joint.ends) {
        end.frame.rotation = glm::normalize(end.frame.rotation);
        if (!end.shape) continue;
        const Shape* shape = m_shapes.find(end.shape);
        if (!shape) return "the handle of a shape is stale";
        if (end.cell.x >= 0 && shape->grid.at(end.cell)) continue;
        const double cells = 1.0 / double(shape->voxelSize);
        const std::optional<glm::ivec3> cell =
            nearestSolidCell(shape->grid, end.frame.position * cells, end.radius * cells);
        if (!cell) return "no voxel to hold on to within the radius of an end";
        end.cell = *cell;
    }
    if (joint.kind == JointKind::Rope)
        initRopePoints(joint, jointToWorld(joint.ends[0]).position, jointToWorld(joint.ends[1]).position);
    return "";
}

JointHandle World::addJoint(Joint joint) {
    const JointHandle handle = m_joints.insert(std::move(joint));
    m_jointIndex.add(handle, m_joints.at(handle));
    return handle;
}

void World::rebuildJointIndex() {
    m_jointIndex.clear();
    m_joints.forEach([&](JointHandle handle, const Joint& joint) { m_jointIndex.add(handle, joint); });
}

bool World::hasActiveWinch() const {
    const auto winds = [&](JointHandle rope) { return m_joints.at(rope).motor.mode != MotorMode::Off; };
    return std::any_of(m_jointIndex.ropes().begin(), m_jointIndex.ropes().end(), winds);
}

Pose World::jointToWorld(const JointEnd& end) const {
    return m_shapes.find(end.shape) ? shapeToWorld(end.shape) * end.frame : end.frame;
}

bool World::isJointedToStatic(BodyHandle body) const {
    if (!m_bodies.find(body)) return false;
    std::set<uint32_t> seen = {body.slot()};
    std::vector<BodyHandle> open = {body};
    while (!open.empty()) {
        const BodyHandle next = open.back();
        open.pop_back();
        for (const ShapeHandle shape : m_bodies.at(next).shapes)
            for (const JointHandle handle : jointsOf(shape)) {
                const Joint& joint = m_joints.at(handle);
                for (const JointEnd& end : joint.ends) {
                    if (end.isFree || joint.hand) continue;
                    const Shape* other = m_shapes.find(end.shape);
                    if (!other || m_bodies.at(other->body).isStatic) return true;
                    if (seen.insert(other->body.slot()).second) open.push_back(other->body);
                }
            }
    }
    return false;
}

void World::setRopes(std::span<const RopeMotion> ropes) {
    for (const RopeMotion& motion : ropes)
        if (Joint* joint = m_joints.find(motion.rope); joint && joint->points.size() == motion.points.size())
            joint->points.assign(motion.points.begin(), motion.points.end());
    if (!ropes.empty())
        for (UndoHistory& undo : m_undo) undo.recordMoves(*this, ropes);
}

/// What undo, redo or a known step did to joints, and to the shapes that they hold on to.
void World::journalJoints(const WorldDelta& before, FrameChanges& changes) {
    for (const auto& [slot, was] : before.joints)
        if (was.first) m_jointIndex.remove(was.first, *was.second);
    for (const auto& [slot, was] : before.joints) {
        const JointHandle is = m_joints.handleAt(slot);
        if (is) m_jointIndex.add(is, m_joints.at(is));
        if (was.first && was.first != is) changes.jointsBroken.push_back({was.first, JointBreak::Removed, {}});
        if (is) (was.first == is ? changes.jointsChanged : changes.jointsCreated).push_back(is);
    }
    for (const auto& [slot, was] : before.shapes) {
        const ShapeHandle is = m_shapes.handleAt(slot);
        if (!is) continue;
        for (const JointHandle joint : m_jointIndex.of(is))
            if (!before.joints.contains(joint.slot())) changes.jointsChanged.push_back(joint);
    }
}

Joint jointAt(const World& world, JointKind kind, ShapeHandle first, ShapeHandle second, const Pose& frame) {
    Joint joint{.kind = kind};
    const std::array<ShapeHandle, 2> shapes = {first, second};
    for (size_t i = 0; i < 2; ++i) {
        joint.ends[i].shape = shapes[i];
        joint.ends[i].frame = frame;
        if (!world.shapes().find(shapes[i])) continue;
        const Pose pose = world.shapeToWorld(shapes[i]);
        joint.ends[i].frame = {pose.inversePoint(frame.position), glm::conjugate(pose.rotation) * frame.rotation};
    }
    return joint;
}

}  // namespace rubble
