#pragma once
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace rubble {

/// A progress bar on stderr. On a terminal it is redrawn in place; elsewhere it prints a line for each tenth.
class Progress {
public:
    /// A bar with the label `what` that is full at `total`.
    Progress(std::string what, int total) : m_what(std::move(what)), m_total(total), m_terminal(isatty(2)) {}
    /// Shows that `done` of the total are done, with the time so far and an estimate of the rest.
    void advance(int done) {
        const double share = m_total > 0 ? double(done) / m_total : 1.0;
        const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
        if (!m_terminal && int(share * 10) == m_lastTenth && done != m_total) return;
        m_lastTenth = int(share * 10);
        const int filled = int(share * kWidth);
        std::fprintf(stderr, "%s%s [%.*s%.*s] %d/%d  %.0f s, %.0f s to go%s", m_terminal ? "\r" : "", m_what.c_str(),
                     filled, kFull, kWidth - filled, kEmpty, done, m_total, elapsed,
                     share > 0.0 ? elapsed * (1.0 / share - 1.0) : 0.0, m_terminal && done != m_total ? "   " : "\n");
    }

private:
    static constexpr int kWidth = 30;
    static constexpr const char* kFull = "##############################";
    static constexpr const char* kEmpty = "..............................";
    std::string m_what;
    int m_total;
    bool m_terminal;
    int m_lastTenth = -1;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

}  // namespace rubble
