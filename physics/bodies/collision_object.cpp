#include "physics/bodies/collision_object.h"

#include <algorithm>
#include <limits>

namespace rubble {

void CollisionObject::setPose(const Pose& newPose) {
    pose = newPose;
    m_cellTransforms.clear();
    filter = {0, 0};
    smallestVoxel = std::numeric_limits<double>::max();
    for (const auto& part : collider.parts) {
        filter.layer |= part->filter().layer;
        filter.mask |= part->filter().mask;
        smallestVoxel = std::min(smallestVoxel, part->voxelSize());
        m_cellTransforms.push_back(part->cellsAt(pose.rotation));
    }
}

}  // namespace rubble
