#pragma once
#include <cstdint>
#include <span>

#include "runtime/assets/assets.h"

namespace rubble {

/// importVox() of bytes in memory; `name` is the file's, for messages and for objects without a name.
Result<Level> importVoxBytes(std::span<const uint8_t> bytes, const std::string& name, const VoxImportSettings& settings,
                             ImportReport* report = nullptr);

}  // namespace rubble
