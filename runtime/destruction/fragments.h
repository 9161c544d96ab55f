#pragma once
#include <vector>

#include "runtime/destruction/carve.h"
#include "runtime/destruction/split.h"

namespace rubble {

/// Parameters of fracture(), beside the sphere and the materials in it.
struct FracturePlan {
    Tool tool = Tool::Any;
    uint32_t seed = 0;
    int64_t unitsPerMetre = 2560;     ///< 1/256 of a cell each
    size_t maxFragments = 300;        ///< fragments get larger until about this many are expected; the rest is dust
    uint64_t minVoxels = 1;           ///< smaller fragments become dust
    uint64_t maxPaneVoxels = 20'000;  ///< how much of a pane breaks at once
};

/// A connected piece that broke off.
struct Fragment {
    Piece piece;          ///< packed: its offset is its lowest cell
    MassMoments moments;  ///< in cells of the grid that it came from
};

/// What broke out of one grid: every voxel that is missing is in a fragment or is dust.
struct FractureResult {
    std::vector<Fragment> fragments;
    CarveResult dust;  ///< its `bricks` and `cells` are those of all that broke, fragments included
};

/// Breaks the voxels within a sphere out of a grid, each class of hardness within its own radius, as fragments and dust
/// in the styles of their materials (see FragmentStyle). Each fragment is connected. The cost grows with the voxels
/// that break. The algorithm is at the top of fragments.cpp.
FractureResult fracture(VoxelGrid& grid, const Brush& sphere, const Palette& palette, const MaterialTable& materials,
                        const FracturePlan& plan);

}  // namespace rubble
