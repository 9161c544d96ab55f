#pragma once
#include <vector>

#include "physics/collision/cover.h"
#include "physics/collision/voxel_contacts.h"

namespace rubble {

/// Bits of ContactPoint::feature: the first body, or the second, is touched as what is round. Its point does not turn
/// with it.
inline constexpr uint64_t kFirstIsRound = uint64_t(1) << 62, kSecondIsRound = uint64_t(1) << 63;

/// A part of a body in a search for contacts: where it is and how it moves.
struct MovingPart : CoveredPart {
    glm::dvec3 origin{0.0};               ///< of its body's frame, from the first's, world axes
    glm::dvec3 velocity{0.0}, spin{0.0};  ///< of its body, world axes
    /// The velocity of a point of it, from the first body's frame origin.
    glm::dvec3 velocityAt(const glm::dvec3& point) const { return velocity + glm::cross(spin, point - origin); }
};

/// Appends the contacts of two parts of which one or both are round. See round_contacts.cpp for the method. partKey:
/// see FeatureCollider::collide().
void collideRound(const MovingPart& first, const MovingPart& second, const NarrowphaseSettings& settings,
                  uint64_t partKey, std::vector<ContactPoint>& out);

}  // namespace rubble
