#include "tests/support/allocation_count.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<size_t> g_allocations = 0;
std::atomic<size_t> g_largest = ~size_t(0);
std::atomic<size_t> g_allocated = 0, g_peak = 0;
std::atomic<bool> g_fails = false, g_failsOthers = false;
std::atomic<size_t> g_beforeFailure = 0, g_failed = 0;
thread_local bool t_madeFailure = false;

/// Whether this call is one that AllocationFailure lets fail.
bool mustFail() {
    if (!g_fails || t_madeFailure == g_failsOthers) return false;
    for (size_t left = g_beforeFailure; left > 0;)
        if (g_beforeFailure.compare_exchange_weak(left, left - 1)) return false;
    ++g_failed;
    return true;
}
}  // namespace

// The operators of clang's thread sanitizer cannot be replaced: there nothing is counted.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define RUBBLE_COUNTS_NOTHING
#endif
#endif

#ifndef RUBBLE_COUNTS_NOTHING
namespace {
void* allocate(size_t size) {
    ++g_allocations;
    void* memory = std::malloc(size ? size : 1);
    const size_t now = g_allocated += malloc_usable_size(memory);
    for (size_t peak = g_peak; peak < now && !g_peak.compare_exchange_weak(peak, now);) continue;
    return memory;
}

void release(void* memory) {
    g_allocated -= malloc_usable_size(memory);
    std::free(memory);
}
}  // namespace

void* operator new(size_t size) {
    if (size > g_largest || mustFail()) throw std::bad_alloc();
    if (void* memory = allocate(size)) return memory;
    throw std::bad_alloc();
}
// std::stable_sort allocates its buffer with this operator. Under a sanitizer the default one would not be ours.
void* operator new(size_t size, const std::nothrow_t&) noexcept {
    return mustFail() ? nullptr : allocate(size);
}
void operator delete(void* memory) noexcept {
    release(memory);
}
void operator delete(void* memory, size_t) noexcept {
    release(memory);
}
#endif

namespace rubble {

void limitAllocations(size_t bytes) {
    g_largest = bytes;
}

AllocationFailure::AllocationFailure(size_t first, Threads threads) {
    g_beforeFailure = first, g_failed = 0;
    t_madeFailure = true, g_failsOthers = threads == Threads::Others;
    g_fails = true;
}

AllocationFailure::~AllocationFailure() {
    g_fails = t_madeFailure = false;
}

bool AllocationFailure::hasHappened() const {
    return g_failed > 0;
}

size_t allocationCount() {
    return g_allocations;
}

size_t allocatedBytes() {
    return g_allocated;
}

size_t peakAllocatedBytes() {
    return g_peak;
}

void countPeakFromNow() {
    g_peak = g_allocated.load();
}

}  // namespace rubble
