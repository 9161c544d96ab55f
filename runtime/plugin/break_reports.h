#pragma once
#include <span>
#include <vector>

#include "runtime/world/history/frame_changes.h"

namespace rubble {

/// Voxels of one material that a step removed near each other.
struct BreakReport {
    uint8_t material = 0;
    uint64_t voxels = 0;
    glm::dvec3 position{0.0};  ///< world: their mean, by the middles of their clouds
    double radius = 0.0;       ///< metres around it that hold the clouds
};

/// Merges the dust clouds of a step, in their order, into as few reports as lie apart; replaces `out`. Each removed
/// voxel is in one of them.
void reportBreaks(std::span<const DustCloud> dust, std::vector<BreakReport>& out);

}  // namespace rubble
