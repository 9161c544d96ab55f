#include "runtime/world/queries/joint_queries.h"

#include <glm/geometric.hpp>
#include <set>
#include <vector>

#include "runtime/core/angles.h"
#include "runtime/world/objects/transforms.h"

namespace rubble {

double jointMovement(const WorldData& world, const Joint& joint) {
    const Pose first = jointToWorld(world, joint.ends[0]), second = jointToWorld(world, joint.ends[1]);
    const glm::dvec3 offset = glm::conjugate(first.rotation) * (second.position - first.position);
    const glm::dquat rotation = glm::conjugate(first.rotation) * second.rotation;
    switch (joint.kind) {
        case JointKind::Hinge:
            return twistAboutX(rotation);
        case JointKind::Prismatic:
            return offset.x;
        case JointKind::Wheel:
            return offset.y;
        case JointKind::Ball:
        case JointKind::Cone: {
            const glm::dvec3 axis = rotation * glm::dvec3(1.0, 0.0, 0.0);
            return deterministicAtan2(glm::length(glm::dvec3(0.0, axis.y, axis.z)), axis.x);
        }
        case JointKind::Rope:
            return glm::length(offset);
        case JointKind::Fixed:
            return 0.0;
    }
    return 0.0;
}

bool isJointedToStatic(const WorldData& world, BodyHandle body) {
    if (!world.bodies.find(body)) return false;
    std::set<uint32_t> seen = {body.slot()};
    std::vector<BodyHandle> open = {body};
    while (!open.empty()) {
        const BodyHandle next = open.back();
        open.pop_back();
        for (const ShapeHandle shape : world.bodies.at(next).shapes)
            for (const JointHandle handle : world.jointIndex.of(shape)) {
                const Joint& joint = world.joints.at(handle);
                for (const JointEnd& end : joint.ends) {
                    if (end.isFree || joint.hand) continue;
                    const Shape* other = world.shapes.find(end.shape);
                    if (!other || world.bodies.at(other->body).isStatic) return true;
                    if (seen.insert(other->body.slot()).second) open.push_back(other->body);
                }
            }
    }
    return false;
}

}  // namespace rubble
