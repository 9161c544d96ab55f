#pragma once
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>

#include "samples/netplay/protocol.h"

namespace netplay {

/// Steps of 1/60 s in real time.
class StepClock {
public:
    /// Waits until a step is due.
    void wait() const { std::this_thread::sleep_until(m_next); }
    /// Takes a step that is due; false: none is. Late steps are made up for, but not more than a second of them.
    bool take() {
        const auto now = Clock::now();
        m_next = std::max(m_next, now - std::chrono::seconds(1));
        if (now < m_next) return false;
        m_next += kStep;
        ++m_steps;
        return true;
    }
    /// The part of a step since the last one that was due.
    double part() const {
        return std::clamp(1.0 - std::chrono::duration<double>(m_next - Clock::now()) / kStep, 0.0, 1.0);
    }
    /// How many were taken.
    int64_t steps() const { return m_steps; }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::nanoseconds kStep{1'000'000'000 / kStepsPerSecond};
    Clock::time_point m_next = Clock::now();
    int64_t m_steps = 0;
};

}  // namespace netplay
