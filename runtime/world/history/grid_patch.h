#pragma once
#include <cstdint>
#include <vector>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// An old version of a grid as its difference from a newer one of equal size: the nodes that the two do not share. It
/// costs what changed; a copy of a grid costs its directory.
class GridPatch {
public:
    /// The patch from `now` back to `was`.
    GridPatch(VoxelGrid was, const VoxelGrid& now);
    /// The old version. `now` must be equal to the grid that the patch was made against.
    VoxelGrid applyTo(VoxelGrid now) const;

private:
    struct Entry {
        glm::ivec3 node;
        NodeRef was;  ///< null: it held no voxels
    };
    std::vector<Entry> m_entries;
    uint64_t m_nowHash;
};

}  // namespace rubble
