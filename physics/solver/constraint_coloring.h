#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "physics/bodies/solver_body.h"
#include "runtime/core/parallel_for.h"

namespace rubble {

/// Orders pairs of bodies into four colors, each a list of tasks that share no body, so that Gauss-Seidel can run the
/// tasks of a color in parallel. The colors come from space instead of a graph: the constrained bodies are divided into
/// strips of equal numbers, across the axis along which they spread the most. Color 0 has the pairs within a strip,
/// colors 1 and 2 those between a strip and the next (even and odd strips), color 3 the few that reach farther, as one
/// task. The order depends on the bodies alone, not on the number of threads.
class ConstraintColoring {
public:
    static constexpr size_t kPairsPerStrip = 128;  ///< fewer than two strips of them keep their order, in one task
    static constexpr size_t kMaxStrips = 8;
    static constexpr size_t kMinParallelItems = 16;  ///< of a color; fewer are done before a thread has woken

    /// pairs: indices of bodies; 0 is the world, which tasks may share.
    void build(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> pairs);
    /// Indices of pairs, in the order in which they are solved.
    std::span<const uint32_t> order() const { return m_order; }
    /// Replaces the range of each task, in order, by f(from, to), a range of what its pairs are packed in.
    void replaceRanges(const std::function<std::pair<size_t, size_t>(size_t, size_t)>& f);
    /// Calls body(from, to) for each task, a range of order(), color after color; the tasks of a color run in parallel
    /// if they have items enough. parallelFor: null: serial.
    void run(const ParallelFor* parallelFor, const std::function<void(size_t, size_t)>& body) const;

private:
    struct Task {
        size_t from, to;
    };
    void assignStrips(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> pairs, size_t strips);

    std::vector<uint32_t> m_order;
    std::vector<std::vector<Task>> m_colors;
    std::vector<uint32_t> m_strip;                            ///< by body
    std::vector<std::pair<double, uint32_t>> m_sortedBodies;  ///< coordinate along the axis, and body
    std::vector<uint32_t> m_key;                              ///< by pair: color and task
};

}  // namespace rubble
