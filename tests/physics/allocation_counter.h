#pragma once
#include <cstddef>

namespace rubble {

/// Calls of operator new in this program so far.
size_t allocationCount();

}  // namespace rubble
