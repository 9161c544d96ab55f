#pragma once
#include <vector>

#include "runtime/world/world.h"

namespace rubble {

/// The sleeping bodies without support, found from the voxels alone, independently of physics' contacts. A body is
/// supported if forces on its surface can balance its weight. They act at points within 2 cm of something static or
/// supported, along the shortest exit, with a friction angle of 45 degrees. A chain of supported bodies must connect it
/// with something static.
std::vector<BodyHandle> findUnsupported(const World& world);
/// The sleeping bodies that nothing bears at this moment, as what is awake, jointed or in water might. They shall wake.
std::vector<BodyHandle> findHanging(const World& world);
/// The dynamic bodies with an edge of a voxel within 2 cm of a box, world.
std::vector<BodyHandle> findTouching(const World& world, glm::dvec3 low, glm::dvec3 high);

}  // namespace rubble
