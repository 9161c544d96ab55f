#pragma once
#include <vector>

#include "physics/collision/round_contacts.h"

namespace rubble {

/// In place of a feature's kind in ContactPoint::feature: a corner of the area that two boxes share.
inline constexpr uint32_t kBoxKind = 22;

/// Appends the contacts of two parts that are boxes (ColliderPart::box()), and returns whether they are near each
/// other, as findContacts() does. The contacts lie in one plane and are the corners of the area that the boxes share
/// there, at most eight, or one point where two edges cross. search: its axis is set to the unit vector from the second
/// to the first along which they are the farthest apart, or overlap the least; its clearance shrinks to theirs.
/// partKey: see FeatureCollider::collide(). See box_contacts.cpp for the method. [any thread]
bool collideBoxes(const MovingPart& first, const MovingPart& second, const NarrowphaseSettings& settings,
                  uint64_t partKey, ContactSearch& search, std::vector<ContactPoint>& out);

}  // namespace rubble
