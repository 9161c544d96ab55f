#pragma once
#include <cstddef>

namespace rubble {

/// How often this program has called operator new, on all threads; 0 under clang's thread sanitizer.
size_t allocationCount();

}  // namespace rubble
