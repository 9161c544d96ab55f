#pragma once
#include <cstddef>

namespace rubble {

/// How often this program has called operator new, on all threads.
size_t allocationCount();

}  // namespace rubble
