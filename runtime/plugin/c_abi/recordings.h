#pragma once
#include <string>

#include "runtime/assets/recording_file.h"
#include "runtime/plugin/c_abi/registry.h"

namespace rubble::abi {

/// Plays a recording that was read in a world; refuses the call if it could not be, if it is of the other kind of
/// world, or if a step has another hash. `name`: of the file. steps: may be null; counts those that had their hash.
void play(HostedWorld& hosted, Result<Recording> recording, const std::string& name, uint64_t* steps);

}  // namespace rubble::abi
