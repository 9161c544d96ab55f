#pragma once
#include <map>
#include <string>
#include <vector>

#include "tests/abi/refusals/host_call.h"

namespace rubble {

/// Files that calls read, and what they hold.
struct CallFiles {
    std::string level, save, recording, scratch;  ///< paths; scratch: of a file that calls may write
    std::vector<uint8_t> levelData, saveData, recordingData, leader, deltas;  ///< leader: which deltas follow
};
/// Those files; makes them with the first call, in a folder that `folder` names.
const CallFiles& callFiles(const std::string& folder = "");

/// The framebuffer that views are drawn into, where there is a GL context.
unsigned& drawTarget();

/// Sets what a call needs beyond what HostCall fills in, so that it is accepted.
using Prepare = void (*)(HostCall&);

/// The ways in which a function is called, which together read all of its arguments. Functions that are not in the
/// table are called as HostCall makes it.
const std::map<std::string, std::vector<Prepare>>& usualCalls();

}  // namespace rubble
