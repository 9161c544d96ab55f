#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/world/queries/query.h"

namespace rubble {

/// Places of rays, in an order in which those that begin near each other and go alike follow each other: what they meet
/// is in the processor's caches then. They are in the cells of a grid, along a Morton curve, and there by octants.
std::vector<uint32_t> coherentOrder(std::span<const RayQuery> rays);

}  // namespace rubble
