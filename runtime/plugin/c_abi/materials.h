#pragma once
#include "runtime/plugin/c_abi/registry.h"

namespace rubble::abi {

/// How many rows the table of materials has once the edits that wait for the next step are done.
size_t waitingMaterials(const HostedWorld& hosted);

}  // namespace rubble::abi
