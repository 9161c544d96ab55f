#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "runtime/assets/vox_file.h"
#include "runtime/core/result.h"

namespace rubble {

/// Turns and mirrors of the lattice of cells, and a whole number of cells: out[i] = sign[i] * in[axis[i]] + offset[i].
struct VoxTransform {
    std::array<uint8_t, 3> axis{0, 1, 2};
    std::array<int8_t, 3> sign{1, 1, 1};
    std::array<int64_t, 3> offset{};
};

/// Applies `child` first.
VoxTransform operator*(const VoxTransform& parent, const VoxTransform& child);

/// A model somewhere in the scene; Z up still.
struct VoxInstance {
    int model = 0;
    VoxTransform transform;  ///< of the model's cells about its pivot (the floor of half its size)
    std::string name;        ///< of the nearest named node on the way to the shape, "" if none is
    std::string layer;
    bool hidden = false;   ///< itself, something above it, or its layer
    int frame = 0;         ///< number of the frame; 0 is what stands, the others are kept hidden
    int skippedPoses = 0;  ///< frames of transforms on the way that were left out
};

/// Walks the scene graph; without one the first model stands on the ground at the origin, as MagicaVoxel shows it,
/// and the others stand in a row beside it.
Result<std::vector<VoxInstance>> voxInstances(const VoxFile& file, const std::string& fileName);

}  // namespace rubble
