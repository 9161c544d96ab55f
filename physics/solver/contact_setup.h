#pragma once
#include <span>
#include <vector>

#include "physics/math/soft_constraint.h"
#include "physics/solver/contact_set.h"

// What the contact solver does once a step, before its substeps.

namespace rubble {

/// The states of the bodies at the start of the step.
void prepareStates(ContactSet& set, std::span<const SolverBody> bodies);
/// Finds how fast the bodies of a pair close and slide, what it starts with, and writes the approach of each point.
/// Reads bodies and states, writes only what belongs to the pair. [any thread]
void classifyPair(const ContactSet& set, PairConstraints& pair, std::span<const SolverBody> bodies);

/// How soft contacts are.
struct ContactSoftness {
    Softness<float> moving, withStatic, stiff;  ///< of two bodies; of a body and the world; of a load-bearing body
};
/// Fills in a group and the contacts at the start of the step, but for what the kernel's prepare() computes. Writes
/// only what belongs to the group. up: unit vector against gravity, or 0. torsionRadius: see SolverSettings.
/// [any thread]
void fillGroup(ContactSet& set, PairGroup& group, std::span<const SolverBody> bodies, const glm::vec3& up,
               const ContactSoftness& softness, float torsionRadius);

/// Sets the impulses of contacts to 0 that would throw a body. No warm start after the loss of a support: what a
/// contact that is gone held back is missing in the balance of impulses.
class WarmStartFilter {
public:
    /// Changes the impulses of the manifolds. states must know which bodies are jointed: these are left alone.
    void reject(ContactSet& set);

private:
    /// The sum of the warm start impulses on a body.
    struct Sum {
        glm::vec3 impulse{0.0f}, angularImpulse{0.0f};
        bool isRejected = false;
    };
    std::vector<Sum> m_sums;  ///< by body
};

/// Bodies that bear much more than their own weight.
class LoadBearing {
public:
    /// Marks the bodies under something `ratio` times as heavy, and those under these in turn that are as light, as far
    /// as they bore `ratio` times their weight in the last step, or nothing yet. Makes their contacts stiff. fall:
    /// speed that gravity adds in a substep, m/s.
    void find(ContactSet& set, const glm::vec3& up, float fall, float ratio);
    /// Forgets the pairs.
    void clear() { m_pairs.clear(); }
    /// Indices of the pairs of such bodies.
    const std::vector<size_t>& pairs() const { return m_pairs; }

private:
    void findLoads(ContactSet& set, const glm::vec3& up);

    std::vector<std::pair<size_t, size_t>> m_supports;  ///< the upper body, the one under it
    std::vector<float> m_loads;                         ///< impulses from above by body, N s a substep
    std::vector<float> m_heaviest;                      ///< 1/kg by body: of the heaviest that it bears; or kNothing
    std::vector<size_t> m_pairs;
};

}  // namespace rubble
