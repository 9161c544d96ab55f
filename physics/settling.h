#pragma once
#include "runtime/core/pose.h"

namespace rubble {

/// How far a body has moved since some earlier moment: decides when it is calm enough to sleep, and when it has moved
/// enough for what lies on it to be woken. Positions, not velocities: a jittering contact keeps its place.
class Settling {
public:
    void restart(const Pose& now);
    /// Counts `seconds` of calm if the body stays within `radius` metres and `angle` radians of where the calm began;
    /// else calm begins anew. Returns the calm so far.
    double calm(const Pose& now, double radius, double angle, double seconds);
    /// True, and the count starts again, if the body has moved by more than `radius` or `angle` since the last true.
    bool disturbed(const Pose& now, double radius, double angle);
    /// Where the body was at the last true of disturbed().
    const Pose& disturbedAt() const { return m_disturbedAt; }

private:
    Pose m_calmAt;
    Pose m_disturbedAt;
    double m_calmSeconds = 0.0;
};

}  // namespace rubble
