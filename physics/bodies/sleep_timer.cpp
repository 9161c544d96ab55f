#include "physics/bodies/sleep_timer.h"

#include <cmath>

namespace rubble {
namespace {

/// Whether two poses are at most `radius` metres and `angle` radians apart. The angle must be small: the distance of
/// two unit quaternions is 2 sin(angle / 4), about angle / 2.
bool within(const Pose& a, const Pose& b, double radius, double angle) {
    const glm::dvec3 offset = a.position - b.position;
    if (glm::dot(offset, offset) > radius * radius) return false;
    const double cosine = std::abs(glm::dot(a.rotation, b.rotation));
    return 2.0 - 2.0 * cosine <= 0.25 * angle * angle;
}

}  // namespace

void SleepTimer::restart(const Pose& now) {
    m_movedPose = now;
    restartRest(now);
}

void SleepTimer::restartRest(const Pose& now) {
    m_restPose = now;
    m_restTime = 0.0;
}

double SleepTimer::restTime(const Pose& now, double radius, double angle, double seconds) {
    if (within(now, m_restPose, radius, angle)) return m_restTime += seconds;
    m_restPose = now;
    return m_restTime = 0.0;
}

bool SleepTimer::hasMoved(const Pose& now, double radius, double angle) {
    if (within(now, m_movedPose, radius, angle)) return false;
    m_movedPose = now;
    return true;
}

}  // namespace rubble
