#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "runtime/voxel/brick.h"

namespace rubble {

/// Direction of each face of a brick, in the order of BrickPart::faces. Face i of a brick touches face i ^ 1 of the
/// brick at this offset.
inline constexpr std::array<glm::ivec3, 6> kFaceOffsets = {
    {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

/// Appends the 6-connected components of the voxels of a brick, the one with the lowest voxel first.
void findBrickParts(const BrickBits& occupancy, std::vector<BrickPart>& out);

/// [any-thread] The components of a brick, computed once and cached in the brick. A brick of very many components is
/// not cached but labelled again each time, in `scratch`, which must outlive the result.
std::span<const BrickPart> brickParts(const Brick& brick, std::vector<BrickPart>& scratch);

/// Calls f(i, j) for each component i of a brick and j of the brick beyond its `face` that touch there. Stops when f
/// returns false, and returns false then.
template <class F>
bool forEachTouchingPair(std::span<const BrickPart> a, std::span<const BrickPart> b, size_t face, F&& f) {
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t j = 0; a[i].faces[face] && j < b.size(); ++j)
            if ((a[i].faces[face] & b[j].faces[face ^ 1]) && !f(i, j)) return false;
    return true;
}

/// [any-thread] The single component of a full brick.
std::span<const BrickPart> fullBrickParts();

}  // namespace rubble
