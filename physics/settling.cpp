#include "physics/settling.h"

#include <cmath>

namespace rubble {
namespace {

/// Of rotations a few hundredths of a radian apart: the chord between unit quaternions is 2 sin(angle / 4).
bool within(const Pose& a, const Pose& b, double radius, double angle) {
    const glm::dvec3 way = a.position - b.position;
    if (glm::dot(way, way) > radius * radius) return false;
    const double cosine = std::abs(glm::dot(a.rotation, b.rotation));
    return 2.0 - 2.0 * cosine <= 0.25 * angle * angle;
}

}  // namespace

void Settling::restart(const Pose& now) {
    m_calmAt = m_disturbedAt = now;
    m_calmSeconds = 0.0;
}

double Settling::calm(const Pose& now, double radius, double angle, double seconds) {
    if (within(now, m_calmAt, radius, angle)) return m_calmSeconds += seconds;
    m_calmAt = now;
    return m_calmSeconds = 0.0;
}

bool Settling::disturbed(const Pose& now, double radius, double angle) {
    if (within(now, m_disturbedAt, radius, angle)) return false;
    m_disturbedAt = now;
    return true;
}

}  // namespace rubble
