#pragma once
#include <string>

#include "runtime/assets/vdb/mesh.h"
#include "runtime/core/result.h"

namespace rubble {

/// Reads a .obj file with the .mtl file and the PNG textures that it names, a .ply file, or a .glb file. Any bytes give
/// a mesh or an error; call it in a process of its own, because the library that reads trusts some of them.
Result<Mesh> readMesh(const std::string& path);

}  // namespace rubble
