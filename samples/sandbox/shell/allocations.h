#pragma once
#include <cstdint>

namespace rubble {

/// Allocations of this program so far. A program that calls it counts them in operator new; 0 with sanitizers.
uint64_t allocationCount();

}  // namespace rubble
