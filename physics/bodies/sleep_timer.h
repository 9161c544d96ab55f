#pragma once
#include "runtime/core/pose.h"

namespace rubble {

/// How far a body has moved since some earlier moment: decides when it is restTime enough to sleep, and when it has
/// moved enough for what lies on it to be woken. Positions, not velocities: a jittering contact keeps its place.
class SleepTimer {
public:
    void restart(const Pose& now);
    /// Counts `seconds` of restTime if the body stays within `radius` metres and `angle` radians of where the restTime
    /// began; else restTime begins anew. Returns the restTime so far.
    double restTime(const Pose& now, double radius, double angle, double seconds);
    /// True, and the count starts again, if the body has moved by more than `radius` or `angle` since the last true.
    bool hasMoved(const Pose& now, double radius, double angle);
    /// Where the body was at the last true of hasMoved().
    const Pose& movedPose() const { return m_movedPose; }

private:
    Pose m_restPose;
    Pose m_movedPose;
    double m_restTime = 0.0;
};

}  // namespace rubble
