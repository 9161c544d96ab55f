#pragma once
#include <vector>

#include "physics/bodies/collision_object.h"
#include "physics/collision/voxel_contacts.h"

namespace rubble {

/// Appends the contacts that two objects will have when they meet in this step, if they meet, as points that are still
/// apart. For fast objects of which findContacts() found none: it follows corners and edges towards faces, but edges do
/// not see each other before they touch. axis: see timeOfImpact(). neighbours: see findContacts(). [any thread]
void findImpactContacts(const CollisionObject& first, const CollisionObject& second,
                        const NarrowphaseSettings& settings, const glm::vec3& axis, std::vector<ContactPoint>& out,
                        const StaticNeighbours& neighbours = {});

}  // namespace rubble
