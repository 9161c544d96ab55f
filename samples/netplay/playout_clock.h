#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace netplay {

/// The step of the server's world that a client shows: some steps behind the newest that it has heard of, so that what
/// comes late or is lost once is there in time. It runs evenly: it gains or loses a fifth at most, and jumps only after
/// a second without news.
class PlayoutClock {
public:
    /// Something that the server sent after a step has arrived.
    void hear(uint64_t step) { m_newest = std::max(m_newest, double(step)); }
    /// A step of 1/60 s has passed.
    void tick() {
        const double target = m_newest - kBehind, ahead = target - m_now;
        if (std::abs(ahead) > kJump)
            m_now = target;
        else
            m_now = std::min(m_now + 1.0 + std::clamp(ahead * 0.05, -0.2, 0.2), m_newest + kBlind);
        m_now = std::max(m_now, 0.0);
    }
    /// The time that is shown, in steps.
    double now() const { return m_now; }

private:
    static constexpr double kBehind = 8.0, kJump = 60.0, kBlind = 6.0;
    double m_newest = 0.0, m_now = 0.0;
};

}  // namespace netplay
