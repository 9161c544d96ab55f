#include "physics/water/water.h"

#include <algorithm>
#include <cmath>

// Buoyancy and drag.
//
// Archimedes: a body that displaces the volume V of water of density rho is lifted by -rho V g at the centroid of V
// (submersion.cpp). With d = rho V / m the acceleration is a = (1 - d) g, as if the body had less gravity: so it is
// integrated with gravity, and what floats still has no velocity. V is that in the middle of the step, where the
// velocity takes the body: bobbing then keeps its energy (leapfrog, drift-kick-drift). Drag is -c rho V (v - u) with
// the flow u, linear in the velocity (Stokes) and in V. It is integrated implicitly together with a, which acts after
// it:
//     v' = u + (v + h a - u) / (1 + h c d) - h a,
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

double WaterVolumes::applyForces(DynamicBody& body, glm::dvec3 gravity, double seconds) {
    SolverBody& motion = body.motion;
    const glm::dvec3 toMiddle = motion.velocity * (0.5 * seconds);  // of the step
    const WorldBox bounds{body.object.low + toMiddle, body.object.high + toMiddle};
    m_near.clear();
    m_tree.find([&](const WorldBox& box) { return box.overlaps(bounds); },
                [&](uint32_t slot) { m_near.push_back(slot); });
    std::sort(m_near.begin(), m_near.end());
    const double before = kineticEnergy(motion);
    double displaced = 0.0, spring = 0.0;  // d, h^2 k
    double drag = 0.0, angularDrag = 0.0;  // h c d
    glm::dvec3 flow(0.0), angularVelocity = motion.angularVelocity;
    for (const uint32_t slot : m_near) {
        const Water& water = *m_waters[slot];
        Submersion sum;
        for (size_t i = 0; i < body.object.collider.parts.size(); ++i)
            addSubmersion(*body.object.collider.parts[i], body.object.cellTransforms()[i],
                          body.object.pose.position + toMiddle, water, sum);
        if (!(sum.volume > 0.0)) continue;
        if (!(displaced > 0.0)) body.waterSlot = slot;
        const double share = sum.volume * water.density * motion.inverseMass;
        displaced += share;
        spring += sum.waterline * water.density * glm::length(gravity) * motion.inverseMass * seconds * seconds;
        drag += seconds * water.linearDrag * share;
        angularDrag += seconds * water.angularDrag * share;
        flow += water.flow * (seconds * water.linearDrag * share);
        const glm::dvec3 lift = gravity * (-sum.volume * water.density * seconds);
        angularVelocity += worldInverseInertia(motion) * glm::cross(sum.moment / sum.volume, lift);
    }
    body.inWater = displaced > 0.0;
    if (!body.inWater) return 0.0;
    motion.gravityScale = float(body.gravityScale - displaced);
    const glm::dvec3 fall = gravity * (seconds * double(motion.gravityScale));
    if (drag > 0.0) flow /= drag;
    const double damping = 1.0 + std::max(0.0, spring - 1.0);
    motion.velocity = flow + (motion.velocity + fall - flow) / (damping + drag) - fall;
    motion.angularVelocity = angularVelocity / (damping + angularDrag);
    return kineticEnergy(motion) - before;
}

double buoyancyWork(const DynamicBody& body, glm::dvec3 gravity) {
    const glm::dvec3 force = gravity * (double(body.motion.gravityScale) - 1.0);  // over mass
    return glm::dot(force, body.motion.position - body.stepStart.position) / body.motion.inverseMass;
}

}  // namespace rubble
