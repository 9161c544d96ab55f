#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "physics/bodies/solver_body.h"
#include "runtime/core/parallel_for.h"

namespace rubble {

/// Which pairs of bodies may be solved side by side. Bodies that touch something stand in strips across the axis along
/// which they spread the most, as many in each; pairs within strips come first, then those between a strip and the
/// next, every other one at a time, then the few that minHalfExtent farther. What follows depends on the bodies, not on
/// the number of threads.
class ConstraintColoring {
public:
    static constexpr size_t kPairsPerStrip = 128;  ///< fewer than two strips of them stay in their order
    static constexpr size_t kMaxStrips = 8;

    /// pairs: of bodies; 0, the world, is in no strip.
    void build(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> pairs);
    /// The pairs' numbers, one task after the other.
    std::span<const uint32_t> order() const { return m_order; }
    /// Goes through all pairs: calls body(from, to) for stretches of order(), stage after stage; stretches of a stage
    /// share no body. parallelFor may be null.
    void run(const ParallelFor* parallelFor, const std::function<void(size_t, size_t)>& body) const;

private:
    struct Task {
        size_t from, to;
    };
    void assignStrips(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> pairs, size_t strips);

    std::vector<uint32_t> m_order;
    std::vector<std::vector<Task>> m_colors;
    std::vector<uint32_t> m_strip;                            ///< of bodies
    std::vector<std::pair<double, uint32_t>> m_sortedBodies;  ///< of bodies, by their place along the axis
    std::vector<uint32_t> m_key;                              ///< of pairs: stage and task
};

}  // namespace rubble
