#pragma once
#include "samples/sandbox/options.h"

namespace rubble {

/// Runs the scripted demolition without a window and writes PNG frames, a contact sheet, an MP4 where ffmpeg is
/// installed, and figures. Returns the exit code.
int runHeadless(const SandboxOptions& options);

}  // namespace rubble
