#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "runtime/assets/vox_file.h"
#include "runtime/core/result.h"

namespace rubble {

/// A signed permutation of the axes and a translation by whole cells: out[i] = sign[i] * in[axis[i]] + offset[i].
struct VoxTransform {
    std::array<uint8_t, 3> axis{0, 1, 2};
    std::array<int8_t, 3> sign{1, 1, 1};
    std::array<int64_t, 3> offset{};
};

/// The transform that applies `child` first.
VoxTransform operator*(const VoxTransform& parent, const VoxTransform& child);

/// A model at its place in the scene, still with z up.
struct VoxInstance {
    int model = 0;
    VoxTransform transform;  ///< of the model's cells about its pivot (the floor of half its size)
    std::string name;        ///< of the nearest named node above the shape, printable; "" if there is none
    std::string layer;       ///< printable; "" if there is none
    bool hidden = false;     ///< the node, one above it, or its layer is hidden
    int frame = 0;           ///< animation frame of the model: 0 is shown, the others are kept as hidden shapes
    int skippedPoses = 0;    ///< how many poses of the transforms above are left out: only the first of each counts
};

/// All models of the scene graph, depth first. Without a scene graph the first model stands on the ground at the
/// origin, as MagicaVoxel shows it, and the others in a row beside it. Errors name the node's place in the file.
Result<std::vector<VoxInstance>> voxInstances(const VoxFile& file, const std::string& fileName);

}  // namespace rubble
