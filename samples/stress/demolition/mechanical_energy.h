#pragma once
#include <vector>

#include "runtime/world/history/frame_changes.h"
#include "runtime/world/world.h"

namespace rubble {

/// Kinetic and potential energy of all dynamic bodies, summed over steps. But for the work of motors, springs, water
/// and characters, a step can only lose energy, so each step without edits to bodies is compared with the step before
/// it.
class MechanicalEnergy {
public:
    /// Call after each step, with the step's journal and PhysicsStats::work. Edits to bodies or a new level start a new
    /// comparison.
    void update(const World& world, const FrameChanges& changes, double work);

    double lost() const { return m_lost; }                 ///< joules, summed over the steps that lost energy
    double gained() const { return m_gained; }             ///< joules, summed over the steps that gained energy
    int comparedSteps() const { return m_comparedSteps; }  ///< steps that could be compared

private:
    struct BodyEnergy {
        BodyHandle body;
        MassProperties mass;
        double energy = 0.0;
        bool awake = false, jointed = false;
    };
    /// Takes the energies of all dynamic bodies as the new baseline.
    void reset(const World& world);
    static double energyOf(const World& world, const Body& body, const BodyEnergy& entry);

    std::vector<BodyEnergy> m_bodies;  ///< dynamic bodies, in slot order
    double m_lost = 0.0, m_gained = 0.0;
    int m_comparedSteps = 0;
    bool m_hasBaseline = false;
};

}  // namespace rubble
