#include "physics/bodies/sleep_timer.h"

#include <algorithm>
#include <cmath>

// When a body is at rest.
//
// A pendulum that turns back and a pillar that begins to fall are as slow as a body at rest. So a body rests only if it
// would not go far in the next kAhead seconds either. Two displacements d1, d2 in h seconds each, one after the other,
// tell how it moves on:
//     its mean velocity, (d1 + d2) / 2h, and acceleration, (d2 - d1) / h^2, are below the limits;
//     if d2 has the direction of d1, what falls from an unstable balance goes q = |d2| / |d1| times as far in each h:
//     together |d2| (q + q^2 + ...), by which it must not leave kReach.
// Jitter of contacts is the larger a part of these, the shorter h is. So h is half of limits.time and doubles of it;
// one that finds rest suffices.

namespace rubble {
namespace {

constexpr double kAhead = 10.0;  ///< s
constexpr double kReach = 0.05;  ///< metres: half a voxel
constexpr double kNoise = 2e-6;  ///< metres that contacts of bodies at rest move them to and fro
constexpr double kCosine = 0.8;  ///< between displacements of the same direction, at least

/// A small motion between two poses.
struct Displacement {
    glm::dvec3 position;
    glm::dquat rotation;  ///< the difference of the quaternions; its length is 2 sin(angle / 4)

    /// An upper bound of how far it moves a point within `radius` metres of the origin, metres.
    double farthest(double radius) const {
        return glm::length(position) + 2.0 * radius * std::sqrt(glm::dot(rotation, rotation));
    }
};

Displacement between(const Pose& from, const Pose& to) {
    const double sign = glm::dot(from.rotation, to.rotation) < 0.0 ? -1.0 : 1.0;
    return {to.position - from.position, to.rotation * sign - from.rotation};
}

/// The scalar product of two motions of a body of that radius, m2.
double product(const Displacement& a, const Displacement& b, double radius) {
    return glm::dot(a.position, b.position) + 4.0 * radius * radius * glm::dot(a.rotation, b.rotation);
}

/// Whether a motion that went on to grow as from `first` to `second`, in equal times, would leave kReach after so many
/// more of them.
bool growsFar(const Displacement& first, const Displacement& second, double radius, double times) {
    const double one = product(first, first, radius), two = product(second, second, radius),
                 both = product(first, second, radius);
    if (two <= kNoise * kNoise || two <= one || both * both < kCosine * kCosine * one * two || both <= 0.0)
        return false;
    const double growth = std::min(std::sqrt(two / one), 1e3);
    double reach = 0.0, next = std::sqrt(two);
    for (int i = 0; i < int(std::ceil(times)) && reach <= kReach; ++i) reach += next *= growth;
    return reach > kReach;
}

}  // namespace

void SleepTimer::restart(const Pose& now) {
    m_movedPose = now;
    restartRest(now);
}

void SleepTimer::restartRest(const Pose& now) {
    m_windows.fill({now, now});
    m_steps = 0;
}

bool SleepTimer::rests(const Pose& now, double radius, const RestLimits& limits) {
    const int64_t shortest = std::max(int64_t(std::llround(0.5 * limits.time / limits.stepSeconds)), int64_t(1));
    ++m_steps;
    bool any = false;
    for (int i = 0; i < kWindows; ++i) {
        Window& w = m_windows[size_t(i)];
        const int64_t steps = shortest << i;
        const double h = double(steps) * limits.stepSeconds;
        if (w.farthest <= limits.velocity * h)  // else how much farther does not matter
            w.farthest = std::max(w.farthest, between(w.start, now).farthest(radius));
        w.isQuiet = w.isQuiet && w.farthest <= limits.velocity * h;
        if (m_steps % steps == 0) {
            const Displacement first = between(w.before, w.start), second = between(w.start, now),
                               change{second.position - first.position, second.rotation - first.rotation};
            w.isQuiet = m_steps > steps && std::max(w.farthestBefore, w.farthest) <= limits.velocity * h &&
                        change.farthest(radius) <= limits.acceleration * h * h &&
                        !growsFar(first, second, radius, kAhead / h);
            w = {w.start, now, w.farthest, 0.0, w.isQuiet};
        }
        any = any || w.isQuiet;
    }
    return any;
}

bool SleepTimer::hasMoved(const Pose& now, double radius, double distance) {
    if (between(m_movedPose, now).farthest(radius) <= distance) return false;
    m_movedPose = now;
    return true;
}

}  // namespace rubble
