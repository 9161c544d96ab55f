#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace rubble {

/// Labels the 6-connected components of a plain array of cells, ordered by x, then y, then z; 0 is empty. Writes for
/// each cell 0 if it is empty, else the number of its component plus one, components ordered by their first cell.
/// Returns the cells of each component. Uses RunLabels.
std::vector<uint64_t> labelDense(glm::ivec3 size, std::span<const uint8_t> cells, std::span<uint32_t> labels);

}  // namespace rubble
