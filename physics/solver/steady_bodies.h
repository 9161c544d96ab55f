#pragma once
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "physics/solver/contact_set.h"

namespace rubble {

/// The warm start of bodies whose contacts keep their normals and arms within the step. The impulses of a substep then
/// give a body the velocity that they gave it in the one before, so that no pass over its contacts is needed.
class SteadyBodies {
public:
    /// Begins a step with packed groups: marks the steady bodies. Not those that are jointed, rotate freely within the
    /// step, or have contacts that are followed; later not those that bounce.
    void begin(ContactSet& set, std::span<const SolverBody> bodies);
    /// Begins a substep: adds what bodies fall in it, m/s, and starts the steady ones. isFirst: of the step, in which
    /// contacts start all bodies.
    void startSubstep(ContactSet& set, const glm::vec3& fall, bool isFirst);

private:
    struct Velocity {
        glm::vec3 linear{0.0f}, angular{0.0f};
    };
    static void markGroups(ContactSet& set);

    std::vector<Velocity> m_before;  ///< by body: before its contacts acted in this substep
    size_t m_steady = 0;             ///< how many bodies
};

}  // namespace rubble
