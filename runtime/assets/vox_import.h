#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "runtime/assets/assets.h"

namespace rubble {

constexpr uint64_t kMaxVoxFileBytes = uint64_t(1) << 30;  ///< larger files are refused, and none is written

/// importVox() of a file in memory. `name`: of the file, for messages and for objects without a name. Any bytes give a
/// valid level or an error.
Result<Level> importVoxBytes(std::span<const uint8_t> bytes, const std::string& name, const VoxImportSettings& settings,
                             ImportReport* report = nullptr);

}  // namespace rubble
