#include "physics/bodies/limit_monitor.h"

#include <fmt/format.h>

#include "runtime/core/log.h"

namespace rubble {

bool LimitMonitor::isOutOfRange(const DynamicBody& body) {
    if (!body.isFartherThan(limits::kMaxDistance, m_origin)) return false;
    const LimitCounts before = m_counts;
    ++m_counts[size_t(LimitKind::Distance)];
    warn(before);
    return true;
}

void LimitMonitor::clamp(DynamicBody& body) {
    const LimitCounts before = m_counts;
    if (body.clamp(m_counts)) warn(before);
}

/// Of kinds whose count was 0 before.
void LimitMonitor::warn(const LimitCounts& before) const {
    static constexpr const char* kWhat[] = {
        "a body was faster than 5,000 m/s; its speed is clamped to that",
        "a body spun faster than 1,000 rad/s; its spin is clamped to that",
        "the mass of a body is below 1e-9 or above 1e12 kg; it is clamped to that range",
        "a body is more than 1,000 km from the middle of the level; it is frozen there"};
    for (size_t i = 0; i < m_counts.size(); ++i)
        if (before[i] == 0 && m_counts[i] > 0) logWarning(fmt::format("physics: {}. More are not reported", kWhat[i]));
}

}  // namespace rubble
