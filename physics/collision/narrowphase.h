#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "physics/collision/broadphase.h"
#include "physics/collision/contact_cache.h"
#include "physics/collision/manifold.h"
#include "physics/collision/resting_contacts.h"
#include "runtime/core/parallel_for.h"

namespace rubble {

/// Computes the contacts of all pairs of a step, in batches that may run in parallel; the result does not depend on the
/// number of threads. It remembers the pairs of the step before, for cached contacts, warm starts and separating axes.
class Narrowphase {
public:
    /// Begins a step: the current pairs become those of the step before.
    void begin();
    /// Adds the manifolds of these pairs, which must be sorted.
    void collide(std::span<const ObjectPair> pairs, const NarrowphaseSettings& settings,
                 const ParallelFor& parallelFor);
    /// Of this step, sorted by first and second; valid until the next begin().
    std::span<Manifold* const> manifolds() const { return m_sets[m_now].list; }
    /// Keeps the impulses of contacts of which nothing is awake any more. To be called when bodies have fallen asleep.
    void keepResting() { m_resting.keep(manifolds()); }
    /// Forgets the contacts of all steps: the next one finds them as if it were the first.
    void forget();
    /// How many pairs it was given in this step.
    size_t candidates() const { return m_sets[m_now].usedPairs; }
    /// Bricks of large bodies that may touch something and were not searched in this step.
    size_t bricksLeftOut() const;

private:
    /// What is remembered of a pair whose bounds overlap.
    struct Pair {
        uint32_t first = 0, second = 0, firstVersion = 0, secondVersion = 0;
        ContactSearch search;
        bool isCacheable = false;            ///< slow
        RelativePose pose;                   ///< at which the contacts were found, or none
        const Manifold* manifold = nullptr;  ///< null: no contacts
    };
    struct Batch {
        std::vector<Manifold> manifolds;
        std::vector<ManifoldPoint> points;  ///< of the manifolds, one after the other
        size_t used = 0, usedPoints = 0, bricksLeftOut = 0;
        std::vector<ContactPoint> contacts;
        LoneManifold rested;
    };
    struct Set {
        std::vector<std::unique_ptr<Batch>> batches;
        size_t usedBatches = 0;
        std::vector<Manifold*> list;
        std::vector<Pair> pairs;  ///< all, sorted; then unused ones
        size_t usedPairs = 0;
        /// Those in use.
        std::span<const Pair> all() const { return std::span(pairs).first(usedPairs); }
    };
    void collideBatch(std::span<const ObjectPair> pairs, size_t from, const NarrowphaseSettings& settings, Batch& batch,
                      std::span<Pair> out) const;
    static void findPairContacts(std::span<const ObjectPair> pairs, size_t number, const NarrowphaseSettings& settings,
                                 double displacement, Batch& batch, Pair& pair);
    void collidePair(std::span<const ObjectPair> pairs, size_t number, const NarrowphaseSettings& settings,
                     const Pair* before, Batch& batch, Pair& pair) const;

    std::array<Set, 2> m_sets;  ///< of this step and of the one before
    RestingContacts m_resting;
    size_t m_now = 0;
};

}  // namespace rubble
