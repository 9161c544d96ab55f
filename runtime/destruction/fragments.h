#pragma once
#include <vector>

#include "runtime/destruction/carve.h"
#include "runtime/destruction/split.h"

namespace rubble {

/// What decides how a zone breaks, besides the zone and the materials in it.
struct FracturePlan {
    Tool tool = Tool::Any;
    uint32_t seed = 0;
    int64_t unitsPerMetre = 2560;   ///< in 1/256 of a cell
    size_t maxFragments = 300;      ///< larger fragments are made so that there are about as many, and never more
    uint64_t minVoxels = 1;         ///< smaller fragments are dust
    uint64_t largestPane = 20'000;  ///< voxels of a pane that break at once
};

struct Fragment {
    Piece piece;          ///< packed: its offset is its lowest cell
    MassMoments moments;  ///< in the cells of the grid that it came from
};

/// What broke out of one grid: fragments and dust, and nothing is lost.
struct FractureResult {
    std::vector<Fragment> fragments;
    CarveResult dust;  ///< its bricks are all that changed
};

/// Takes the voxels within a sphere out of the grid, each class of hardness within its own radius, as fragments and
/// dust in the style of their materials (see FragmentStyle). Each fragment is connected. Costs the voxels that break.
FractureResult fracture(VoxelGrid& grid, const Brush& sphere, const Palette& palette, const MaterialTable& materials,
                        const FracturePlan& plan);

}  // namespace rubble
