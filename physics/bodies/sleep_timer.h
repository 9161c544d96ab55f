#pragma once
#include <array>
#include <cstdint>

#include "runtime/core/pose.h"

namespace rubble {

/// What counts as rest.
struct RestLimits {
    double time = 0.0;          ///< s that a body rests at least
    double velocity = 0.0;      ///< m/s, mean over that time, of its farthest point
    double acceleration = 0.0;  ///< m/s2, the same
    double stepSeconds = 0.0;   ///< of a step
};

/// Decides when a body has come to rest, and when it has moved enough to wake what touches it. It compares poses, not
/// velocities: contacts jitter. See sleep_timer.cpp for the rule.
class SleepTimer {
public:
    /// Starts all measurements from here.
    void restart(const Pose& now);
    /// Starts the measurement of rest from here.
    void restartRest(const Pose& now);
    /// Ends a step of a body whose farthest point is `radius` metres from its origin; true: it rests.
    bool rests(const Pose& now, double radius, const RestLimits& limits);
    /// Whether a point of the body is more than `distance` metres from where it was when this was last true.
    bool hasMoved(const Pose& now, double radius, double distance);

private:
    static constexpr int kWindows = 5;  ///< of limits.time times 1, 2, 4, 8 and 16

    /// Two halves of one length; the second is running.
    struct Window {
        Pose before, start;                           ///< where the halves begin
        double farthestBefore = 0.0, farthest = 0.0;  ///< metres from there, in each half
        bool isQuiet = false;                         ///< it was at rest when its second half last ended
    };

    std::array<Window, kWindows> m_windows;
    int64_t m_steps = 0;
    Pose m_movedPose;
};

}  // namespace rubble
