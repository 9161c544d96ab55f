#pragma once
#include <string>

namespace rubble {

/// Writes a small level as a .rubble file into the temporary folder and returns its path: a table of a material on one
/// leg, 17 x 10 x 17 voxels of 0.1 m, that comes apart when it is hit in the middle from above, and a light over it.
std::string writeTestLevel(const char* material = "brick");

}  // namespace rubble
