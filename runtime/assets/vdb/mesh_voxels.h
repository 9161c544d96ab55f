#pragma once
#include <string>
#include <vector>

#include "runtime/assets/vdb/mesh.h"
#include "runtime/core/result.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// How a mesh becomes voxels.
struct MeshSettings {
    int voxels = 64;         ///< cells along the mesh's longest side; 0: as long in metres as the file says
    double voxelSize = 0.1;  ///< metres
    int shell = 0;           ///< cells that its walls are thick; 0: solid
    bool isZUp = false;      ///< whether z is up in the file, else y
    bool isSmooth = false;   ///< textures are read bilinear, else by the nearest pixel
};

/// Makes a level of a mesh: one static body with one shape, of which the mesh's origin is the body's. What became of
/// what, and what leaks, goes into `notes`.
Result<Level> voxelise(const Mesh& mesh, const std::string& name, const MeshSettings& settings,
                       std::vector<std::string>& notes);

}  // namespace rubble
