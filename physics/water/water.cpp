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
// What is light and small moves by more than its height within a step. Its d is the mean along the way that it takes
// with this d, for then a . (x1 - x0) is the integral of the force and energy is kept (a discrete gradient: Gonzalez,
// "Time Integration and Discrete Hamiltonian Systems", 1996). A light body bobs on a stiff spring: the waterline area A
// gives rho A |g| / m. Where h^2 times that exceeds 1, explicit integration would throw the body out, and the excess is
// added to the denominator as damping.

namespace rubble {
namespace {

/// Of half a body's smallest side, by which buoyancy may lift it in a step that needs no mean.
constexpr double kMaxRise = 0.25;
constexpr size_t kMaxSamples = 128;

/// In water `number` of several, without what is in those before it.
Submersion submersionOf(const DynamicBody& body, Waters waters, size_t number, const glm::dvec3& offset) {
    Submersion sum;
    for (size_t i = 0; i < body.object.collider.parts.size(); ++i)
        addSubmersion(*body.object.collider.parts[i], body.object.cellTransforms()[i],
                      body.object.pose.position + offset, *waters[number], sum, waters.first(number));
    return sum;
}

/// The mean of a function of the height over the way of a body that has this mean as its acceleration. start, speed: of
/// the body, metres and m/s upwards; fall: m/s2 downwards; most: of the function, m/s2; samples: of it at equal
/// distances from `low` to `high`, between which the way lies.
double meanAlongWay(const std::vector<double>& samples, double low, double high, double speed, double fall, double most,
                    double seconds) {
    const double spacing = (high - low) / double(samples.size() - 1);
    const auto integralTo = [&](double height) {  // of the function from `low`
        const double at = std::clamp((height - low) / spacing, 0.0, double(samples.size() - 1));
        double sum = 0.0;
        size_t i = 0;
        for (; double(i + 1) <= at; ++i) sum += 0.5 * (samples[i] + samples[i + 1]);
        const double rest = at - double(i);
        if (rest > 0.0) sum += rest * (samples[i] + 0.5 * rest * (samples[i + 1] - samples[i]));
        return sum * spacing;
    };
    const double fromStart = integralTo(0.0);
    double least = 0.0, mean = most;
    for (int i = 0; i < 40; ++i) {  // the higher it gets, the less water is on the way
        mean = 0.5 * (least + most);
        const double way = (speed + 0.5 * (mean - fall) * seconds) * seconds;
        const double along = std::abs(way) > 1e-9 ? (integralTo(way) - fromStart) / way : mean;
        (along > mean ? least : most) = mean;
    }
    return mean;
}

}  // namespace

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

void WaterVolumes::findNear(const WorldBox& bounds) {
    m_near.clear();
    m_tree.find([&](const WorldBox& box) { return box.overlaps(bounds); },
                [&](uint32_t slot) { m_near.push_back(slot); });
    std::sort(m_near.begin(), m_near.end());
    m_nearWaters.clear();
    for (const uint32_t slot : m_near) m_nearWaters.push_back(&*m_waters[slot]);
}

double WaterVolumes::applyForces(DynamicBody& body, glm::dvec3 gravity, double seconds) {
    SolverBody& motion = body.motion;
    const glm::dvec3 toMiddle = motion.velocity * (0.5 * seconds);  // of the step
    const WorldBox bounds{body.object.low + glm::min(2.0 * toMiddle, 0.0),
                          body.object.high + glm::max(2.0 * toMiddle, 0.0)};
    findNear(bounds);
    body.inWater = false;
    if (m_near.empty()) return 0.0;
    const double before = kineticEnergy(motion);
    double displaced = 0.0, spring = 0.0;  // d, h^2 k
    double drag = 0.0, angularDrag = 0.0;  // h c d
    glm::dvec3 flow(0.0), angularVelocity = motion.angularVelocity;
    for (size_t i = 0; i < m_near.size(); ++i) {
        const Water& water = *m_nearWaters[i];
        const Submersion sum = submersionOf(body, m_nearWaters, i, toMiddle);
        if (!(sum.volume > 0.0)) continue;
        if (!(displaced > 0.0)) body.waterSlot = m_near[i];
        const double share = sum.volume * water.density * motion.inverseMass;
        displaced += share;
        spring += sum.waterline * water.density * glm::length(gravity) * motion.inverseMass * seconds * seconds;
        drag += seconds * water.linearDrag * share;
        angularDrag += seconds * water.angularDrag * share;
        flow += water.flow * (seconds * water.linearDrag * share);
        const glm::dvec3 lift = gravity * (-sum.volume * water.density * seconds);
        angularVelocity += worldInverseInertia(motion) * glm::cross(sum.moment / sum.volume, lift);
    }
    const double g = glm::length(gravity), most = mostDisplaced(body);
    const bool isLight = g * most * seconds * seconds > 2.0 * kMaxRise * body.minHalfExtent();
    if (isLight) {
        const double mean = meanDisplaced(body, gravity, most, seconds);
        if (displaced > 0.0) {
            angularVelocity = glm::mix(motion.angularVelocity, angularVelocity, mean / displaced);
        } else {
            body.waterSlot = m_near[0];
        }
        const Water& water = *m_waters[body.waterSlot];
        displaced = mean, drag = seconds * water.linearDrag * mean, angularDrag = seconds * water.angularDrag * mean;
        flow = water.flow * drag;
    }
    body.inWater = displaced > 0.0;
    if (!body.inWater) return 0.0;
    if (drag > 0.0) flow /= drag;
    // The mean keeps the energy by itself.
    const double damping = isLight ? 1.0 : 1.0 + std::max(0.0, spring - 1.0);
    motion.gravityScale = float(body.gravityScale - displaced);
    const glm::dvec3 fall = gravity * (seconds * double(motion.gravityScale)),
                     end = flow + (motion.velocity + fall - flow) / (damping + drag);
    // Where drag is strong, buoyancy that acts after it would first push it down.
    if (isLight) motion.gravityScale = float(glm::dot(end - motion.velocity, gravity) / (g * g * seconds));
    motion.velocity = end - gravity * (seconds * double(motion.gravityScale));
    motion.angularVelocity = angularVelocity / (damping + angularDrag);
    return kineticEnergy(motion) - before;
}

double WaterVolumes::mostDisplaced(const DynamicBody& body) const {
    double volume = 0.0, density = 0.0;
    for (const auto& part : body.object.collider.parts)
        volume += double(part->grid().voxelCount()) * std::pow(part->voxelSize(), 3);
    for (const Water* water : m_nearWaters) density = std::max(density, water->density);
    return volume * density * body.motion.inverseMass;
}

double WaterVolumes::meanDisplaced(const DynamicBody& body, glm::dvec3 gravity, double most, double seconds) const {
    const double g = glm::length(gravity), speed = -glm::dot(body.motion.velocity, gravity) / g,
                 fall = body.gravityScale * g;
    const glm::dvec3 up = gravity / -g, aside = (body.motion.velocity - up * speed) * (0.5 * seconds);
    const double low = std::min(0.0, (speed - 0.5 * fall * seconds) * seconds),
                 high = std::max(0.0, (speed + 0.5 * (most * g - fall) * seconds) * seconds),
                 spacing = kMaxRise * body.minHalfExtent();
    std::vector<double> samples(std::min(size_t((high - low) / spacing) + 2, kMaxSamples));
    for (size_t i = 0; i < samples.size(); ++i) {
        const double height = low + (high - low) * double(i) / double(samples.size() - 1);
        for (size_t k = 0; k < m_near.size(); ++k)
            samples[i] += submersionOf(body, m_nearWaters, k, aside + up * height).volume * m_nearWaters[k]->density *
                          body.motion.inverseMass * g;
    }
    return meanAlongWay(samples, low, high, speed, fall, most * g, seconds) / g;
}

double buoyancyWork(const DynamicBody& body, glm::dvec3 gravity) {
    const glm::dvec3 force = gravity * (double(body.motion.gravityScale) - 1.0);  // over mass
    return glm::dot(force, body.motion.position - body.stepStart.position) / body.motion.inverseMass;
}

}  // namespace rubble
