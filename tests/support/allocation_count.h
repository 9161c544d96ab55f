#pragma once
#include <cstddef>

namespace rubble {

/// How often this program has called operator new, on any thread.
size_t allocationCount();

}  // namespace rubble
