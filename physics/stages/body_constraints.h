#pragma once
#include <span>
#include <vector>

#include "physics/solver/joint_rows.h"
#include "physics/stages/physics_bodies.h"
#include "runtime/world/history/frame_changes.h"

namespace rubble {

/// What edits hold for one step: see BodyConstraint. [main-thread]
class BodyConstraints {
public:
    /// Replaces them by those of a step, without those whose bodies are gone by its end, and wakes their bodies.
    void set(const FrameChanges& changes, const World& world, PhysicsBodies& bodies);
    /// As rows for the solver, in the order of the edits; valid until the next call. Bodies must know their solver
    /// index.
    std::span<JointConstraint> gather(PhysicsBodies& bodies);
    /// Whether the last gather() had any: then they may have done any work, in joules, as hands may.
    double work() const;

private:
    std::vector<BodyConstraint> m_given;
    std::vector<JointConstraint> m_rows;  ///< of the last gather()
};

}  // namespace rubble
