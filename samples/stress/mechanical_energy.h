#pragma once
#include <vector>

#include "runtime/world/frame_changes.h"
#include "runtime/world/world.h"

namespace rubble {

/// Kinetic energy and weight of all dynamic bodies, followed from step to step. Contacts and friction can only take of it:
/// steps in which nothing was cut, shoved or put anywhere are compared with the step before.
class MechanicalEnergy {
public:
    /// After a step; changes: its journal. A new level begins anew.
    void see(const World& world, const FrameChanges& changes);

    double lost() const { return m_lost; }        ///< joules, in all steps that lost some
    double gained() const { return m_gained; }    ///< and in those that ended with more than they began with
    double mostGained() const { return m_most; }  ///< joules, in one step
    int stepsCompared() const { return m_compared; }

private:
    struct Part {
        BodyHandle body;
        MassProperties mass;
        double energy = 0.0;
        bool awake = false;
    };
    /// Energy of all that is dynamic, after everything was cut or moved anyhow.
    void beginAnew(const World& world);
    static double energyOf(const World& world, const Body& body, const MassProperties& mass);

    std::vector<Part> m_parts;  ///< dynamic bodies, in slot order
    double m_lost = 0.0, m_gained = 0.0, m_most = 0.0;
    int m_compared = 0;
    bool m_isKnown = false;
};

}  // namespace rubble
