#pragma once
#include <cstddef>

namespace rubble {

/// How often this program has called operator new, on all threads; 0 under clang's thread sanitizer.
size_t allocationCount();
/// From now on operator new throws std::bad_alloc for more bytes than this at once, on all threads.
void limitAllocations(size_t bytes);
/// How many bytes operator new has given and not got back, on all threads; 0 as above.
size_t allocatedBytes();
/// The most that allocatedBytes() has been since the last call of countPeakFromNow().
size_t peakAllocatedBytes();
/// See peakAllocatedBytes().
void countPeakFromNow();

}  // namespace rubble
