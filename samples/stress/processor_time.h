#pragma once
#include <ctime>
#include <map>
#include <string>

namespace stress {

/// Processor time of all threads, by what was done.
class ProcessorTime {
public:
    /// What is done from now on.
    void enter(const char* what) {
        const double time = now();
        if (m_sum) *m_sum += time - m_since;
        m_sum = &m_seconds[what];
        m_since = time;
    }

    /// Up to now.
    std::map<std::string, double> seconds() {
        if (m_sum) *m_sum += now() - m_since;
        m_sum = nullptr;
        return m_seconds;
    }

private:
    static double now() {
        timespec time = {};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
    }

    std::map<std::string, double> m_seconds;
    double* m_sum = nullptr;
    double m_since = 0.0;
};

}  // namespace stress
