#include <algorithm>
#include <cmath>

#include "runtime/world/world.h"

namespace rubble {

Edits World::damageFrom(std::span<const Impact> impacts) const {
    std::vector<const Impact*> hardest;
    for (const Impact& impact : impacts) {
        if (!(impact.impulse >= m_settings.impactThreshold)) continue;
        double heavier = 0.0;
        for (const BodyHandle handle : {impact.body, impact.other})
            if (const Body* body = m_bodies.find(handle); body && !body->isStatic) heavier = std::max(heavier, bodyMass(handle).mass);
        if (impact.impulse >= m_settings.impactSpeed * heavier) hardest.push_back(&impact);
    }
    std::stable_sort(hardest.begin(), hardest.end(), [](const Impact* a, const Impact* b) { return a->impulse > b->impulse; });
    if (hardest.size() > m_settings.impactsAStep) hardest.resize(m_settings.impactsAStep);
    Edits edits;
    for (const Impact* impact : hardest) {
        // The broken area grows with the impulse, so the radius with its root; harder classes need a harder hit.
        const double force = impact->impulse / m_settings.impactThreshold;
        const auto radius = [&](double share) { return std::min(m_settings.impactRadiusLimit, m_settings.impactRadius * std::sqrt(force * share)); };
        CarveEdit edit{.position = impact->position};
        edit.radii = {radius(1.0), force >= 2.0 ? radius(0.5) : 0.0, force >= 8.0 ? radius(0.125) : 0.0};
        edits.push_back(edit);
    }
    return edits;
}

}  // namespace rubble
