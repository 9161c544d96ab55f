#include "physics/settling.h"

namespace rubble {
namespace {

/// Of rotations a few hundredths of a radian apart: |A - B| in the Frobenius norm is 2 sqrt(2) sin(angle / 2).
bool within(const btTransform& a, const btTransform& b, double radius, double angle) {
    if (double(a.getOrigin().distance2(b.getOrigin())) > radius * radius) return false;
    double sum = 0.0;
    for (int row = 0; row < 3; ++row) sum += double((a.getBasis()[row] - b.getBasis()[row]).length2());
    return sum <= 2.0 * angle * angle;
}

}  // namespace

void Settling::restart(const btTransform& now) {
    m_calmAt = m_disturbedAt = now;
    m_calmSeconds = 0.0;
}

double Settling::calm(const btTransform& now, double radius, double angle, double seconds) {
    if (within(now, m_calmAt, radius, angle)) return m_calmSeconds += seconds;
    m_calmAt = now;
    return m_calmSeconds = 0.0;
}

bool Settling::disturbed(const btTransform& now, double radius, double angle) {
    if (within(now, m_disturbedAt, radius, angle)) return false;
    m_disturbedAt = now;
    return true;
}

}  // namespace rubble
