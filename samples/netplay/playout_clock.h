#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace netplay {

/// The step of the server's world that a client shows: some steps behind the newest that it has heard of, so that what
/// comes late or is lost once is there in time. It runs evenly: it gains or loses a fifth at most, and jumps only after
/// a second without news. It stands still where something is missing, and from then on stays farther behind.
class PlayoutClock {
public:
    /// Something that the server sent after a step has arrived.
    void hear(uint64_t step) { m_newest = std::max(m_newest, double(step)); }
    /// A step of 1/60 s has passed. complete: up to there nothing is missing that must not be.
    void tick(uint64_t complete) {
        const double target = m_newest - m_behind, ahead = target - m_now;
        double next = target;
        if (std::abs(ahead) <= kJump)
            next = std::min(m_now + 1.0 + std::clamp(ahead * 0.05, -0.2, 0.2), m_newest + kBlind);
        const double missing = next - double(complete);
        m_behind = std::clamp(m_behind + (missing > 0.0 ? std::min(missing, 1.0) : -kForget), kLeast, kMost);
        m_now = std::max(std::min(next, double(complete)), m_now);
    }
    /// The time that is shown, in steps.
    double now() const { return m_now; }

private:
    static constexpr double kLeast = 8.0, kMost = 40.0, kJump = 60.0, kBlind = 6.0;
    static constexpr double kForget = 1.0 / 600.0;  ///< that it comes nearer again: a step in ten seconds
    double m_newest = 0.0, m_now = 0.0, m_behind = kLeast;
};

}  // namespace netplay
