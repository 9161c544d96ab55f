#pragma once
#include <span>
#include <vector>

#include "runtime/destruction/components.h"
#include "runtime/destruction/cross_section.h"
#include "runtime/destruction/stress_graph.h"

namespace rubble {

/// The cells to remove so that a section opens: of each two cells that touch there, the one of the weaker material; of
/// equally strong ones, one by a hash of the position, so that the crack is rough. Anchored and unbreakable cells stay.
std::vector<BrickSubset> crackCells(const VoxelGrid& grid, std::span<const CellBox> anchors,
                                    const StrengthTable& entries, const Section& section);

}  // namespace rubble
