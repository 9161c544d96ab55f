#pragma once
#include <string>
#include <vector>

namespace editor {

/// How a mesh becomes voxels, as the options of rubble-vdb.
struct MeshOptions {
    int voxels = 64;     ///< along its longest side; 0: as long in metres as the file says
    double voxel = 0.1;  ///< metres
    int shell = 0;       ///< voxels that its walls are thick; 0: solid
    bool isZUp = false, isSmooth = false;
};

/// Whether a path ends as those of meshes do: .obj, .ply, .glb.
bool isMeshFile(const std::string& path);
/// Makes a level of a mesh, by the program rubble-vdb. The report of what became what. Throws Refused.
std::vector<std::string> bakeMesh(const std::string& path, const std::string& output, const std::string& vdbTool,
                                  const MeshOptions& options);

}  // namespace editor
