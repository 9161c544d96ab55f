#pragma once
#include <cstdint>

/// Constants that the shaders see under the same names.
namespace rubble::shared {

using uint = uint32_t;
#include "shaders/shared/constants.h"

}  // namespace rubble::shared
