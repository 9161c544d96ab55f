#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>

#include "runtime/core/parallel_for.h"

namespace rubble {

/// Calls f(i) for each i below count, in blocks that may run in parallel. parallelFor: null, or few items: serial.
/// kBlockSize: items that are worth a task.
template <size_t kBlockSize = 64, class F>
void forEachBlockwise(const ParallelFor* parallelFor, size_t count, F&& f) {
    constexpr size_t kMinParallelBlocks = 4;
    const auto runBlock = [&](size_t block) {
        for (size_t i = block * kBlockSize; i < std::min(count, (block + 1) * kBlockSize); ++i) f(i);
    };
    if (parallelFor && count >= kMinParallelBlocks * kBlockSize)
        return (*parallelFor)((count + kBlockSize - 1) / kBlockSize, std::ref(runBlock));
    for (size_t i = 0; i < count; ++i) f(i);
}

}  // namespace rubble
