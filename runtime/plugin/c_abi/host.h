#pragma once
#include "runtime/plugin/include/rubble/rubble.h"

namespace rubble::abi {

/// The services that set_host() has copied; all null at first. Changes only in set_host(), which no other call runs
/// beside.
const rubble_host& host();

}  // namespace rubble::abi
