#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace rubble {

/// 6-connected components of a plain array of cells, x fastest, then y: for data that is not in bricks. `cells`: 0 =
/// empty. Writes 0 for an empty cell, else its component's number plus one, components ordered by their first cell;
/// returns the voxels of each. See RunLabels.
std::vector<uint64_t> labelDense(glm::ivec3 size, std::span<const uint8_t> cells, std::span<uint32_t> labels);

}  // namespace rubble
