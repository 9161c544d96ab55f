#pragma once
#include <cstddef>

namespace rubble::test {

/// Calls of operator new in this program so far.
size_t countAllocations();

}  // namespace rubble::test
