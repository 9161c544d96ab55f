#pragma once
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "runtime/voxel/brick.h"

namespace rubble {

/// The direction of each of BrickPart::faces; face i ^ 1 of the neighbour there touches face i.
inline constexpr std::array<glm::ivec3, 6> kFaceOffsets = {
    {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

/// Appends the components inside a brick, the one with the lowest voxel first. Flood fill on whole words of occupancy.
void findBrickParts(const BrickBits& occupancy, std::vector<BrickPart>& out);

/// The same, worked out once a brick; only a brick of a great many parts is done anew each time, in `scratch`.
std::span<const BrickPart> brickParts(const Brick& brick, std::vector<BrickPart>& scratch);

}  // namespace rubble
