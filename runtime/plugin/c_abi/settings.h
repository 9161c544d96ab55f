#pragma once
#include "runtime/plugin/c_abi/registry.h"

namespace rubble::abi {

/// The settings that the edits which wait for the next step leave, before those of later calls.
WorldSettings waitingSettings(const HostedWorld& hosted);

}  // namespace rubble::abi
