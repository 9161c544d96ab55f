#pragma once
#include <array>
#include <span>
#include <vector>

#include "physics/collision/broadphase.h"
#include "physics/collision/contact_cache.h"
#include "physics/collision/manifold.h"
#include "runtime/core/parallel_for.h"

namespace rubble {

/// Contacts of all pairs of a step, in batches that may run side by side; the result does not depend on how many do.
class Narrowphase {
public:
    /// Begins a step: what is known becomes what was.
    void begin();
    /// Adds the manifolds of these sorted pairs that touch.
    void collide(std::span<const ObjectPair> pairs, const NarrowphaseSettings& settings,
                 const ParallelFor& parallelFor);
    /// The same for pairs of which some may have been looked at in this step: those without contacts are looked at
    /// again.
    void collideAgain(std::span<const ObjectPair> pairs, const NarrowphaseSettings& settings);
    /// Of this step, sorted by first and second, valid until the next begin().
    std::span<Manifold* const> manifolds() const { return m_sets[m_now].list; }

private:
    /// What is known of two whose bounds overlap.
    struct Pair {
        uint32_t first = 0, second = 0, firstVersion = 0, secondVersion = 0;
        glm::vec3 axis{0.0f};                ///< see findContacts()
        bool isCacheable = false;            ///< they were near each other and slow
        RelativePose place;                  ///< at which contacts were found
        const Manifold* manifold = nullptr;  ///< none: they do not touch
    };
    struct Batch {
        std::vector<Manifold> manifolds;
        size_t used = 0;
        std::vector<ContactPoint> contacts;
    };
    struct Set {
        std::vector<std::unique_ptr<Batch>> batches;
        size_t usedBatches = 0;
        std::vector<Manifold*> list;
        std::vector<Pair> pairs;  ///< all, sorted
    };
    void collideBatch(std::span<const ObjectPair> pairs, const NarrowphaseSettings& settings, Batch& batch,
                      std::span<Pair> out) const;
    static void collidePair(const ObjectPair& objects, const NarrowphaseSettings& settings, const Pair* before,
                            Batch& batch, Pair& pair);

    std::array<Set, 2> m_sets;
    size_t m_now = 0;
};

}  // namespace rubble
