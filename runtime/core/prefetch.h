#pragma once
#include <cstddef>

namespace rubble {

/// Begins to load bytes from memory that will be read soon; null does nothing. What a program does between two steps
/// takes the caches, so that a step would wait for much of what it reads.
inline void prefetch(const void* from, size_t bytes) {
    constexpr size_t kLine = 64;
    for (size_t at = 0; at < bytes; at += kLine) __builtin_prefetch(static_cast<const char*>(from) + at);
}

}  // namespace rubble
