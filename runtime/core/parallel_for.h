#pragma once
#include <cstddef>
#include <functional>

namespace rubble {

/// Runs body(i) for i in [0, count), in any order, perhaps on several threads; returns when all are done.
/// Results must not depend on the order or on the number of threads.
using ParallelFor = std::function<void(size_t count, const std::function<void(size_t)>& body)>;

/// A ParallelFor on the calling thread, in order: the default where a host supplies none.
inline void serialFor(size_t count, const std::function<void(size_t)>& body) {
    for (size_t i = 0; i < count; ++i) body(i);
}

}  // namespace rubble
