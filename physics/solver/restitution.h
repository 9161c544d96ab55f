#pragma once
#include <span>
#include <utility>
#include <vector>

#include "physics/solver/contact_set.h"
#include "physics/solver/joint_solver.h"

namespace rubble {

/// Elastic impacts. What closes fast and is about to touch bounces before the contacts are solved, and hands the
/// impact on through what touches it. See restitution.cpp for the method.
class Restitution {
public:
    /// Begins a step, with the constraints as they are prepared. minRebound: what would part more slowly than this,
    /// m/s, does not bounce.
    void begin(ContactSet& set, float minRebound);
    /// The impacts of the next substep, of this length, in a fixed order. To be called before each iteration over the
    /// contacts, which would take the speed.
    void solve(ContactSet& set, float seconds, std::span<const SolverBody> bodies, JointSolver& joints);

private:
    /// The speed at which a point parts that has this normal velocity (m/s, below 0: closing); 0: it does not bounce.
    float reboundSpeed(const ManifoldPoint& point, float velocity) const;
    void findNeighbours(const ContactSet& set);
    bool isAboutToBounce(ContactSet& set, const PairConstraints& pair, float seconds) const;
    void collide(ContactSet& set, const PairConstraints& pair, float seconds, std::span<const SolverBody> bodies,
                 JointSolver& joints);
    void queue(size_t pair);

    float m_minRebound = 0.25f;        ///< m/s
    std::vector<size_t> m_fast;        ///< pairs that close fast at the start of the step
    std::vector<size_t> m_neighbours;  ///< elastic pairs of each body
    std::vector<size_t> m_ends;        ///< by body: where its neighbours end
    std::vector<size_t> m_queue;       ///< pairs to look at
    std::vector<uint8_t> m_impacts;    ///< by pair, in this substep
    std::vector<bool> m_isQueued;      ///< by pair
    int m_jointRounds = 0;             ///< that are left in this substep
};

}  // namespace rubble
