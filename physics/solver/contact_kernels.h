#pragma once
#include <cstddef>

namespace rubble {

struct SolverState;
struct PairGroup;
struct Lanes;
template <class Real>
struct Contact;
template <class Real>
struct ContactStart;

/// A pass over contacts.
struct ContactPass {
    float inverseSeconds;     ///< of the substep
    float maxPushSpeed;       ///< m/s at which overlaps are pushed apart
    float slop;               ///< metres that contacts may overlap
    bool useBias = false;     ///< before the bodies move; false: after they have moved
    bool addsTotals = false;  ///< first adds the impulses of the substep before to the totals
    bool haveMoved = false;   ///< the bodies have, since the last pass: separations are computed again
};

/// What the contact kernels work on: the arrays of a ContactSet.
struct ContactArrays {
    SolverState* states;
    PairGroup* groups;
    Contact<Lanes>* contacts;
    const ContactStart<Lanes>* starts;
};

/// The inner loops of the contact solver, over groups [from, to). There are two builds of contact_kernels.cpp, which
/// give the same bits. Groups that share no body may be given to several threads.
struct ContactKernels {
    /// Fills in what follows from the start of the contacts.
    void (*prepare)(const ContactArrays& set, size_t from, size_t to);
    /// Starts a substep with the impulses of the one before. isFirst: of the step; else steady bodies are left out.
    void (*warmStart)(const ContactArrays& set, size_t from, size_t to, bool isFirst);
    /// An iteration over the contacts.
    void (*solve)(const ContactArrays& set, size_t from, size_t to, const ContactPass& pass);
};

/// For every processor.
const ContactKernels& baselineContactKernels();
/// Those for AVX2; null: this processor or this build has none.
const ContactKernels* avx2ContactKernels();
/// The fastest ones that this processor can run.
const ContactKernels& contactKernels();

}  // namespace rubble
