#pragma once
#include <vector>

#include "runtime/world/world.h"

namespace rubble {

/// The sleeping bodies that nothing holds up, found from the voxels alone, not from what physics thinks touches. Held
/// up is what forces on its surface can balance: at points within 2 cm of something that is static or held up itself,
/// pushing along the nearest distance out, with the friction of 45 degrees; and what a chain of such bodies joins to
/// something static.
std::vector<BodyHandle> findUnsupported(const World& world);
/// The movable bodies with an edge of a voxel within 2 cm of a box of the world.
std::vector<BodyHandle> findTouching(const World& world, glm::dvec3 low, glm::dvec3 high);

}  // namespace rubble
