#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// A row of a file's grid table.
struct VdbGridEntry {
    std::string name, type;
};

/// Checks the header, the metadata's sizes and the grid table of a .vdb file without OpenVDB, whose reader trusts them:
/// counts, lengths and offsets must lie inside the file. The content of the grids is not checked. `name`: of the file,
/// for messages.
Result<std::vector<VdbGridEntry>> scanVdbHeader(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace rubble
