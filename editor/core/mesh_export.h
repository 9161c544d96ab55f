#pragma once
#include <cstdint>
#include <rubble/rubble.hpp>
#include <string>
#include <vector>

namespace editor {

/// What a file of meshes holds.
struct MeshCounts {
    size_t shapes = 0, faces = 0;  ///< faces: rectangles
};

/// Writes shapes as greedy meshes with the colours of their voxels, whole or not at all: .obj, in metres of the world,
/// or .glb, a node for each shape. Their faces are those of rubble.h's mesh_brick(). Throws Refused.
MeshCounts writeMeshes(const rubble::World& world, const std::vector<rubble_shape>& shapes, const std::string& path);

/// Writes a file, whole or not at all: beside it, to the disk, and over it. Throws Refused.
void writeFile(const std::string& path, const std::string& bytes);

}  // namespace editor
