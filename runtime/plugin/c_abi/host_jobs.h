#pragma once
#include <fmt/format.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>

namespace rubble::abi {

/// A ParallelFor that the host's job system runs. Nothing is thrown through the host's code: what a job throws is
/// thrown when the host has returned. Throws as well if the host has not made each call once.
struct HostJobs {
    void* user;
    /// As rubble_world_settings.parallel_for.
    void (*parallelFor)(void* user, uint32_t count, void (*job)(void* context, uint32_t index), void* context);

    void operator()(size_t count, const std::function<void(size_t)>& body) const {
        Run run{.body = body, .count = count};
        parallelFor(user, uint32_t(count), runOne, &run);
        if (run.thrown) std::rethrow_exception(run.thrown);
        if (run.calls != count)
            throw std::runtime_error(
                fmt::format("parallel_for: expected {} calls of the job, found {}", count, run.calls.load()));
    }

private:
    struct Run {
        const std::function<void(size_t)>& body;
        size_t count;
        std::atomic<size_t> calls = 0;
        std::mutex mutex;
        std::exception_ptr thrown;  ///< the first
    };
    static void runOne(void* context, uint32_t index) {
        Run& run = *static_cast<Run*>(context);
        ++run.calls;
        try {
            if (index >= run.count) throw std::runtime_error("parallel_for: an index is not below count");
            run.body(index);
        } catch (...) {
            const std::lock_guard lock(run.mutex);
            if (!run.thrown) run.thrown = std::current_exception();
        }
    }
};

}  // namespace rubble::abi
