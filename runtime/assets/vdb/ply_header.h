#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace rubble {

/// Reads the header of a .ply file, which Assimp's reader trusts: it reads on for ever where the header does not end.
/// What is wrong with it, also that it promises more than the bytes after it can hold; empty: nothing.
std::string plyHeaderError(std::span<const uint8_t> bytes);

}  // namespace rubble
