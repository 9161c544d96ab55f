#pragma once
#include <cstdint>
#include <vector>

#include "runtime/destruction/block_matrix.h"

namespace rubble {

/// An approximate inverse of a stiffness matrix, good at any size: smoothed aggregation with rigid bodies as coarse
/// nodes (Vanek, Mandel & Brezina 1996), one symmetric cycle an application. Set up in slices of work.
class StressMultigrid {
public:
    /// Takes the stiffness of nodes at these places.
    void begin(BlockMatrix stiffness, std::vector<glm::dvec3> centers);
    /// Goes on until it is set up or `work` (6x6 products with a vector) is spent; true if it is set up.
    bool setUp(int64_t& work);
    /// z = about the inverse times r.
    void apply(const std::vector<Vector6>& r, std::vector<Vector6>& z);
    /// What one application costs.
    int64_t applyWork() const { return m_applyWork; }
    const BlockMatrix& stiffness() const { return m_levels.front().a; }

private:
    struct Level {
        BlockMatrix a, p, restriction, ap;
        std::vector<glm::dvec3> center, coarseCenter;  ///< of its nodes and of their aggregates
        std::vector<Block6> inverse;                   ///< of the diagonal
        std::vector<uint32_t> aggregate;
        size_t aggregates = 0;
        std::vector<Vector6> x, r, rest;
    };
    enum class Phase : uint8_t { Diagonal, Aggregate, Prolongation, Product, Coarse, Done };

    void enter(Phase phase) { m_phase = phase, m_row = 0; }
    void stepRow(int64_t& work);
    void aggregate(Level& level);
    void appendProlongationRow(Level& level, size_t row);
    int64_t nextLevel();
    void factor(const BlockMatrix& a);
    void solveCoarsest(const std::vector<Vector6>& r, std::vector<Vector6>& x) const;
    void cycle(size_t level);

    std::vector<Level> m_levels;
    BlockMatrix m_coarse;
    std::vector<double> m_factor;  ///< dense Cholesky of the last level, row after row; empty: that level only smooths
    Phase m_phase = Phase::Done;
    size_t m_row = 0;
    int64_t m_applyWork = 0;
};

}  // namespace rubble
