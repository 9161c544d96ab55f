#pragma once
#include <span>
#include <vector>

#include "physics/collision/manifold.h"
#include "runtime/world/world.h"

namespace rubble {

/// The fastest, m/s, that the first nears the second along a normal of points that they reach within the step: away
/// from the second. Zero: they reach none.
glm::dvec3 approachVelocity(const Manifold& manifold, double seconds);
inline double approachSpeed(const Manifold& manifold, double seconds) {
    return glm::length(approachVelocity(manifold, seconds));
}

/// The hits of a step: contacts that were approached faster than minSpeed and took more than `threshold` N s, added up
/// for each pair of bodies, in the order of pairs. handles: by body slot.
void findImpacts(std::span<Manifold* const> manifolds, double minSpeed, double threshold,
                 const std::vector<BodyHandle>& handles, std::vector<Impact>& out);

}  // namespace rubble
