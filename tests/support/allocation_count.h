#pragma once
#include <cstddef>

namespace rubble {

/// How often this program has called operator new, on all threads; 0 under clang's thread sanitizer.
size_t allocationCount();
/// From now on operator new throws std::bad_alloc for more bytes than this at once, on all threads.
void limitAllocations(size_t bytes);
/// While it lives, operator new throws std::bad_alloc: on the thread that made it, or on all others. One at a time.
class AllocationFailure {
public:
    enum class Threads { This, Others };
    /// first: how many calls of operator new come before those that fail.
    explicit AllocationFailure(size_t first, Threads threads = Threads::This);
    ~AllocationFailure();
    AllocationFailure(const AllocationFailure&) = delete;
    AllocationFailure& operator=(const AllocationFailure&) = delete;
    /// Whether a call has failed.
    bool hasHappened() const;
};
/// How many bytes operator new has given and not got back, on all threads; 0 as above.
size_t allocatedBytes();
/// The most that allocatedBytes() has been since the last call of countPeakFromNow().
size_t peakAllocatedBytes();
/// See peakAllocatedBytes().
void countPeakFromNow();

}  // namespace rubble
