#pragma once
#include <vector>

#include "runtime/world/history/frame_changes.h"
#include "runtime/world/world.h"

namespace rubble {

/// Kinetic energy and weight of all dynamic bodies, followed from step to step. Contacts and friction can only take of
/// it: steps in which nothing was cut, shoved or put anywhere are comparedSteps with the step before.
class MechanicalEnergy {
public:
    /// After a step; changes: its journal. A new level begins anew.
    void update(const World& world, const FrameChanges& changes);

    double lost() const { return m_lost; }            ///< joules, in all steps that lost some
    double gained() const { return m_gained; }        ///< and in those that ended with more than they began with
    double maxGained() const { return m_maxGained; }  ///< joules, in one step
    int comparedSteps() const { return m_comparedSteps; }

private:
    struct BodyEnergy {
        BodyHandle body;
        MassProperties mass;
        double energy = 0.0;
        bool awake = false;
    };
    /// Energy of all that is dynamic, after everything was cut or moved anyhow.
    void reset(const World& world);
    static double energyOf(const World& world, const Body& body, const MassProperties& mass);

    std::vector<BodyEnergy> m_bodies;  ///< dynamic bodies, in slot order
    double m_lost = 0.0, m_gained = 0.0, m_maxGained = 0.0;
    int m_comparedSteps = 0;
    bool m_hasBaseline = false;
};

}  // namespace rubble
