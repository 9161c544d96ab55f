#pragma once
#include <ctime>

#include "render/gl/gl.h"
#include "tests/support/cpu_time.h"

namespace rubble::bench {

/// Milliseconds to time frames by, read after glFinish(). On a software GL: processor time of all threads, which other
/// work on the machine hardly disturbs. On a GPU: the wall clock, because no processor time shows the GPU's work.
inline double frameClockMs() {
    if (isSoftwareGl()) return processMs();
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}
/// What frameClockMs() counts, for the heads of tables.
inline const char* frameClockName() {
    return isSoftwareGl() ? "of processor time" : "by the wall clock";
}

}  // namespace rubble::bench
