#pragma once
#include <ctime>

namespace rubble {

/// The processor time of this thread so far, milliseconds.
inline double threadMs() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}
/// The processor time of all threads of this process so far, milliseconds.
inline double processMs() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}
/// Milliseconds of this thread's processor time in f().
template <class F>
double cpuMs(F&& f) {
    const double start = threadMs();
    f();
    return threadMs() - start;
}

}  // namespace rubble
