#pragma once
#include "runtime/core/pose.h"

namespace rubble {

/// Decides when a body has rested long enough to sleep, and when it has moved enough to wake what touches it. It
/// compares positions, not velocities: a contact that jitters stays in its place.
class SleepTimer {
public:
    /// Starts both measurements from here.
    void restart(const Pose& now);
    /// Counts the rest from here again.
    void restartRest(const Pose& now);
    /// Adds `seconds` to the rest time if the body is still within `radius` metres and `angle` radians of where the
    /// rest began; else the rest begins here. Returns the rest time, s.
    double restTime(const Pose& now, double radius, double angle, double seconds);
    /// Whether the body is more than `radius` metres or `angle` radians from where this was last true.
    bool hasMoved(const Pose& now, double radius, double angle);

private:
    Pose m_restPose;
    Pose m_movedPose;
    double m_restTime = 0.0;
};

}  // namespace rubble
