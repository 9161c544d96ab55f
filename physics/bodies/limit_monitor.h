#pragma once
#include "physics/bodies/dynamic_body.h"
#include "physics/bodies/limits.h"

namespace rubble {

/// Keeps bodies within the limits, counts what was beyond them, and logs a warning for the first of each kind.
class LimitMonitor {
public:
    /// How often each limit was exceeded.
    const LimitCounts& counts() const { return m_counts; }
    /// Goes on from the counts of another; nothing is warned of twice.
    void setCounts(const LimitCounts& counts) { m_counts = counts; }
    /// Sets the middle of the level, from which distances count; before the first body.
    void setOrigin(glm::dvec3 origin) { m_origin = origin; }
    /// Whether the body is more than limits::kMaxDistance from the origin; counts it if it is.
    bool isOutOfRange(const DynamicBody& body);
    /// Clamps the body's speed, spin and mass.
    void clamp(DynamicBody& body);

private:
    void warn(const LimitCounts& before) const;

    glm::dvec3 m_origin{0.0};
    LimitCounts m_counts{};
};

}  // namespace rubble
