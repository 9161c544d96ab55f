#include "physics/water/water.h"

#include <algorithm>
#include <cmath>

// Buoyancy and drag.
//
// Archimedes: a body that displaces the volume V of water of density rho is lifted by -rho V g at the centroid of V
// (submersion.cpp). Drag is -c rho V (v - u) with the flow u, linear in the velocity (Stokes) and in V. It is
// integrated implicitly together with gravity, which acts after it: with d = rho V / m,
//     v' = u + (v + h g - u) / (1 + h c d) - h g,
// so that drag never adds energy, however strong it is, and a sinking body ends at the terminal velocity.
// A light body bobs on a stiff spring: the waterline area A gives rho A |g| / m. Where h^2 times that exceeds 1,
// explicit integration would throw the body out, and the excess is added to the denominator as damping.

namespace rubble {

std::optional<WorldBox> WaterVolumes::set(uint32_t slot, const Water* water) {
    if (m_waters.size() <= slot) m_waters.resize(slot + 1);
    std::optional<WorldBox> touched;
    if (m_waters[slot]) touched = m_waters[slot]->bounds();
    m_count += size_t(water != nullptr) - size_t(m_waters[slot].has_value());
    m_waters[slot].reset();
    m_tree.remove(slot);
    if (!water) return touched;
    m_waters[slot] = *water;
    m_tree.update(slot, water->bounds());
    return touched ? touched->merged(water->bounds()) : water->bounds();
}

const Water* WaterVolumes::at(glm::dvec3 point) const {
    const WorldBox here{point, point};
    uint32_t found = ~0u;
    m_tree.find([&](const WorldBox& box) { return box.overlaps(here); },
                [&](uint32_t slot) {
                    if (slot < found && m_waters[slot]->contains(point)) found = slot;
                });
    return found == ~0u ? nullptr : &*m_waters[found];
}

bool WaterVolumes::applyForces(DynamicBody& body, glm::dvec3 gravity, double seconds) {
    m_near.clear();
    const WorldBox bounds{body.object.low, body.object.high};
    m_tree.find([&](const WorldBox& box) { return box.overlaps(bounds); },
                [&](uint32_t slot) { m_near.push_back(slot); });
    std::sort(m_near.begin(), m_near.end());
    bool isWet = false;
    for (const uint32_t slot : m_near) {
        const Water& water = *m_waters[slot];
        Submersion sum;
        for (size_t i = 0; i < body.object.collider.parts.size(); ++i)
            addSubmersion(*body.object.collider.parts[i], body.object.cellTransforms()[i], body.object.pose.position,
                          water, sum);
        if (!(sum.volume > 0.0)) continue;
        isWet = true;
        SolverBody& motion = body.motion;
        const double displaced = sum.volume * water.density * motion.inverseMass;  // d
        body.applyImpulse(gravity * (-sum.volume * water.density * seconds), motion.position + sum.moment / sum.volume);
        // h^2 rho A |g| / m
        const double stiffness =
            sum.waterline * water.density * glm::length(gravity) * motion.inverseMass * seconds * seconds;
        const double damping = 1.0 + std::max(0.0, stiffness - 1.0);
        const glm::dvec3 fall = gravity * seconds;
        const double kept = 1.0 / (damping + seconds * water.linearDrag * displaced);
        motion.velocity = water.flow + (motion.velocity + fall - water.flow) * kept - fall;
        motion.angularVelocity *= 1.0 / (damping + seconds * water.angularDrag * displaced);
    }
    return isWet;
}

}  // namespace rubble
