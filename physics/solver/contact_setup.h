#pragma once
#include <span>
#include <vector>

#include "physics/solver/contact_constraint.h"

// What the contact solver does once a step, before its substeps.

namespace rubble {

/// The states of the bodies at the start of the step.
void prepareStates(ContactSet& set, std::span<const SolverBody> bodies);
/// Moves the point at which two bodies get a contact's impulses to where they meet now, and computes what follows from
/// it. The touched points of the two are apart before a hit and move on within the step; impulses at one point, that of
/// the feature, halfway to the face that it touches, keep the angular momentum. [any thread]
void updateJacobian(ContactConstraint& c, const SolverState& A, const SolverState& B);
/// Fills in the constraints of a pair. Reads bodies and states, writes only what belongs to the pair. up: unit vector
/// against gravity, or 0. [any thread]
void preparePair(ContactSet& set, PairConstraints& pair, std::span<const SolverBody> bodies, const glm::vec3& up);

/// Sets the impulses of contacts to 0 that would throw a body. No warm start after the loss of a support: what a
/// contact that is gone held back is missing in the balance of impulses.
class WarmStartFilter {
public:
    /// states must know which bodies are jointed: these are left alone.
    void reject(ContactSet& set);

private:
    /// The sum of the warm start impulses on a body.
    struct Sum {
        Float4 impulse{}, angularImpulse{};
        bool isRejected = false;
    };
    std::vector<Sum> m_sums;  ///< by body
};

/// Bodies that bear much more than their own weight.
class LoadBearing {
public:
    /// Marks the bodies under something `ratio` times as heavy, and those under these in turn, as far as they bore
    /// `ratio` times their weight in the last step, or nothing yet. Makes their contacts stiff. fall: speed that
    /// gravity adds in a substep, m/s.
    void find(ContactSet& set, const glm::vec3& up, float fall, float ratio);
    /// Forgets the pairs.
    void clear() { m_pairs.clear(); }
    /// Indices of the pairs of such bodies.
    const std::vector<size_t>& pairs() const { return m_pairs; }

private:
    void findLoads(ContactSet& set, const glm::vec3& up);

    std::vector<std::pair<size_t, size_t>> m_supports;  ///< the upper body, the one under it
    std::vector<float> m_loads;                         ///< impulses from above by body, N s a substep
    std::vector<size_t> m_pairs;
};

}  // namespace rubble
