#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace rubble {

/// Checks what Assimp's reader trusts in a .glb file: that its nodes are trees, as glTF demands, so that none is
/// visited twice; that indices are below the count of vertices; and that meshes are not compressed. What is wrong, or
/// "".
std::string glbError(std::span<const uint8_t> bytes);

}  // namespace rubble
