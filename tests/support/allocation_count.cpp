#include "tests/support/allocation_count.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<size_t> g_allocations = 0;
std::atomic<size_t> g_largest = ~size_t(0);
}  // namespace

// The operators of clang's thread sanitizer cannot be replaced: there nothing is counted.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define RUBBLE_COUNTS_NOTHING
#endif
#endif

#ifndef RUBBLE_COUNTS_NOTHING
void* operator new(size_t size) {
    ++g_allocations;
    if (size > g_largest) throw std::bad_alloc();
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}
// std::stable_sort allocates its buffer with this operator. Under a sanitizer the default one would not be ours.
void* operator new(size_t size, const std::nothrow_t&) noexcept {
    ++g_allocations;
    return std::malloc(size ? size : 1);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
    std::free(memory);
}
#endif

namespace rubble {

void limitAllocations(size_t bytes) {
    g_largest = bytes;
}

size_t allocationCount() {
    return g_allocations;
}

}  // namespace rubble
