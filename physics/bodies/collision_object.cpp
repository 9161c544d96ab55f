#include "physics/bodies/collision_object.h"

namespace rubble {

void CollisionObject::setPose(const Pose& newPose) {
    pose = newPose;
    m_cellTransforms.clear();
    filter = {0, 0};
    for (const auto& part : collider.parts) {
        filter.layer |= part->filter().layer;
        filter.mask |= part->filter().mask;
        m_cellTransforms.push_back(part->cellsAt(pose.rotation));
    }
}

}  // namespace rubble
