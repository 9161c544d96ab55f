#pragma once

namespace rubble {

/// Modules that LLVM has begun in this process: llvmpipe makes one for each program that it builds. 0 with other
/// drivers.
int llvmModules();

}  // namespace rubble
