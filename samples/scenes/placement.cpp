#include "samples/scenes/placement.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace rubble::scenes {

namespace {

glm::dquat turnRotation(Turn turn) {
    switch (turn) {
        case Turn::Quarter:
            return {kSqrtHalf, 0, kSqrtHalf, 0};
        case Turn::Half:
            return {0, 0, 1, 0};
        case Turn::ThreeQuarters:
            return {kSqrtHalf, 0, -kSqrtHalf, 0};
        case Turn::Askew:
            return glm::normalize(glm::dquat(1.0, 0, 0.04, 0));
        case Turn::None:
            break;
    }
    return {1, 0, 0, 0};
}

}  // namespace

void addStatic(Level& level, LevelShape shape, ivec3 cell) {
    LevelBody body;
    body.name = shape.name;
    body.pose.position = glm::dvec3(cell) * kVoxel;
    body.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(body));
}

void addDynamic(Level& level, LevelShape shape, ivec3 cell, Turn turn) {
    const glm::dvec3 size = shape.grid.size();
    // A quarter turn about y takes x to -z and z to x: the shift brings the low corner back to the cell.
    glm::dvec3 shift(0.0);
    if (turn == Turn::Quarter) shift.z = size.x;
    if (turn == Turn::Half) shift = {size.x, 0, size.z};
    if (turn == Turn::ThreeQuarters) shift.x = size.z;
    LevelBody body;
    body.name = shape.name;
    body.isStatic = false;
    body.pose.position = (glm::dvec3(cell) + shift) * kVoxel;
    body.pose.rotation = turnRotation(turn);
    body.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(body));
}

Joint& addHinged(Level& level, const std::string& holder, ivec3 corner, LevelShape leaf, ivec3 cell,
                 const glm::dvec3& pivot) {
    const glm::dquat upright(kSqrtHalf, 0.0, 0.0, kSqrtHalf);  // turns x, the axis of a hinge's frame, to y
    LevelJoint hinge{{.name = leaf.name + " hinge", .kind = JointKind::Hinge}, {holder, leaf.name}};
    hinge.joint.ends[0].frame = {(pivot + glm::dvec3(cell - corner)) * kVoxel, upright};
    hinge.joint.ends[1].frame = {pivot * kVoxel, upright};
    addDynamic(level, std::move(leaf), cell);
    return level.joints.emplace_back(std::move(hinge)).joint;
}

uint32_t addLightGroup(Level& level, std::string name, float threshold) {
    LightGroup group;
    group.name = std::move(name);
    group.threshold = threshold;
    level.lightGroups.push_back(std::move(group));
    return uint32_t(level.lightGroups.size());
}

void addLight(Level& level, const std::string& shape, uint32_t group, LightKind kind, glm::dvec3 cell, glm::vec3 color,
              float reach, float radius) {
    LevelLight entry;
    entry.shapeName = shape;
    entry.groupName = level.lightGroups[group - 1].name;
    entry.light.name = entry.groupName;
    entry.light.kind = kind;
    entry.light.local.position = cell * kVoxel;
    if (kind == LightKind::Cone) entry.light.local.rotation = {kSqrtHalf, -kSqrtHalf, 0, 0};
    entry.light.color = color;
    entry.light.reach = reach;
    entry.light.radius = radius;
    entry.light.coneInner = 0.75f;
    entry.light.coneOuter = 1.15f;
    level.lights.push_back(std::move(entry));
}

Pose lookAt(glm::dvec3 from, glm::dvec3 to) {
    // A rotation matrix with columns right, up, back as a quaternion. Only square roots: no sine that differs by
    // library.
    const glm::dvec3 back = glm::normalize(from - to);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
    const glm::dvec3 up = glm::cross(back, right);
    return {from, glm::normalize(glm::quat_cast(glm::dmat3(right, up, back)))};
}

}  // namespace rubble::scenes
