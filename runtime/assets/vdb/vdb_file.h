#pragma once
#include <string>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// Writes a level as grids and metadata, whole or not at all. Each shape has grids named after it: palette_index
/// (Int32, what readers go by), density (Float, what viewers show), color (Vec3S, linear RGB, a preview) and, where
/// used, emission (Float), light_group and paint (Int32). Everything else is JSON in the file's metadata "rubble.*",
/// field by field as in level_fields.h.
Result<Done> writeVdbFile(const std::string& path, const Level& level);

/// Reads such a file; a field that is missing in the JSON has its default. Reads any other .vdb file as occupancy:
/// Float fog volumes and level sets, Bool and Mask. `notes`: what was skipped, guessed or changed by other programs.
/// OpenVDB trusts what it reads and may crash on a damaged file: call this in a process of its own.
Result<Level> readVdbFile(const std::string& path, std::vector<std::string>& notes);

}  // namespace rubble
