#pragma once
#include <string>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// A level in the OpenVDB profile: for each shape palette_index (Int32, the authority), density (float), color (Vec3S)
/// and, where used, emission and light_group; all else as JSON in the file's metadata, field by field as in
/// level_fields.h. A field that is missing has its default: a shape without "strength" has that of its materials, one
/// without "bears_load" is weighed. Written to a neighbour, then renamed.
Result<Done> writeVdbFile(const std::string& path, const Level& level);

/// Reads the profile, or any other .vdb file as occupancy (Float fog and level sets, Bool, Mask). Trusts nothing but
/// the library itself: run it in a process that may die. `notes`: what was skipped, guessed or changed by others.
Result<Level> readVdbFile(const std::string& path, std::vector<std::string>& notes);

}  // namespace rubble
