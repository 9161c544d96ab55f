#pragma once
#include "samples/sandbox/options.h"

namespace rubble {

/// The scripted demolition without a window: PNG frames, contact sheet, MP4 where ffmpeg is there, figures. Exit code.
int runHeadless(const SandboxOptions& options);

}  // namespace rubble
