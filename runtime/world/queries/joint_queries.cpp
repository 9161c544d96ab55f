#include "runtime/world/queries/joint_queries.h"

#include <set>
#include <vector>

namespace rubble {

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
