#pragma once
#include "tests/physics/physics_scene.h"

namespace rubble::known {

/// Kinetic and potential energy of all dynamic bodies, joules; heights count from y = 0. lag: seconds by which
/// positions are later than velocities. Bodies with contacts or joints have the velocity of the middle of the last
/// substep.
double mechanicalEnergy(const World& world, double lag);

/// Follows the energy of bodies with contacts or joints: what they gained from nothing, and what they lost, in joules.
class EnergyRecord {
public:
    /// Begins with the energy of now.
    EnergyRecord(const World& world, const PhysicsSettings& settings);
    /// Call after each step. work: joules that motors did in it.
    void update(const World& world, double work = 0.0);
    /// By how much the energy ever exceeded that of the start and the work.
    double excess() const { return m_highest - m_start; }
    /// Of all steps that lost.
    double lost() const { return m_lost; }
    /// Of all steps that gained.
    double gained() const { return m_gained; }

private:
    double m_lag;
    double m_start, m_last, m_highest, m_lost = 0.0, m_gained = 0.0, m_work = 0.0;
};

}  // namespace rubble::known
