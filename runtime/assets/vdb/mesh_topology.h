#pragma once
#include <vector>

#include "runtime/assets/vdb/mesh.h"

namespace rubble {

/// The parts of a mesh: triangles that hang together by their points.
struct MeshParts {
    std::vector<bool> isOpen;  ///< by triangle: whether its part has open edges
    size_t count = 0, open = 0;
    size_t openEdges = 0;  ///< those of an odd number of triangles, but for seams: several short ones along a long one
    bool isTurnedAlike = true;  ///< neighbours have the same side outside
};

/// Tells closed parts, which have an inside, from others.
MeshParts findParts(const Mesh& mesh);
/// The volume of some triangles by the divergence theorem: that of their inside where they are closed and turned alike.
double volumeOf(const Mesh& mesh, const std::vector<bool>& isLeftOut);

}  // namespace rubble
