#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

struct VdbGridEntry {
    std::string name, type;
};

/// Reads the header, metadata sizes and grid table of a .vdb file without OpenVDB, whose reader trusts them: counts,
/// lengths and offsets must lie inside the file. Grids' own bytes are not looked at.
Result<std::vector<VdbGridEntry>> scanVdbHeader(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace rubble
