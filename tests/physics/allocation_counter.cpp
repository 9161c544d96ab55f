#include "tests/physics/allocation_counter.h"

#include <cstdlib>
#include <new>

static size_t g_count = 0;

void* operator new(size_t size) {
    ++g_count;
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
    std::free(memory);
}

namespace rubble {

size_t allocationCount() {
    return g_count;
}

}  // namespace rubble
