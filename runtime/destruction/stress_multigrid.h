#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/destruction/block_matrix.h"

namespace rubble {

/// A multigrid preconditioner for stiffness matrices of rigid bodies and springs: an approximate inverse whose quality
/// does not depend on the size of the matrix. The algorithm is at the top of stress_multigrid.cpp. Set up in slices of
/// work.
class StressMultigrid {
public:
    /// Begins with a stiffness matrix. centers: of the nodes, by row, in cells.
    void begin(BlockMatrix stiffness, std::vector<glm::dvec3> centers);
    /// Goes on with the setup until it is complete or `work` (products of a 6x6 block with a vector) is spent. Returns
    /// whether it is complete.
    bool setUp(int64_t& work);
    /// z = approximate inverse times r: one symmetric V-cycle. After the setup.
    void apply(const std::vector<Vector6>& r, std::vector<Vector6>& z);
    /// The work of one apply().
    int64_t applyWork() const { return m_applyWork; }
    /// The matrix of begin().
    const BlockMatrix& stiffness() const { return m_levels.front().a; }

private:
    struct Level {
        BlockMatrix a;                                 ///< stiffness
        BlockMatrix p, restriction;                    ///< prolongation from the coarser level, and its transpose
        BlockMatrix ap;                                ///< a p, during the setup
        std::vector<glm::dvec3> center, coarseCenter;  ///< of its nodes and of their aggregates
        std::vector<Block6> inverse;                   ///< of the diagonal blocks
        std::vector<uint32_t> aggregate;               ///< by node
        size_t aggregates = 0;
        std::vector<Vector6> x, r, rest;  ///< solution, right-hand side, residual
    };
    enum class Phase : uint8_t { Diagonal, Aggregate, Prolongation, Product, Coarse, Done };

    void enter(Phase phase) { m_phase = phase, m_row = 0; }
    void stepRow(int64_t& work);
    void aggregate(Level& level);
    void appendProlongationRow(Level& level, size_t row);
    void addCoarseLevel();
    int64_t nextLevel();
    void factor(const BlockMatrix& a);
    void solveCoarsest(const std::vector<Vector6>& r, std::vector<Vector6>& x) const;
    void cycle(size_t level);

    std::vector<Level> m_levels;
    BlockMatrix m_coarse;          ///< the stiffness of the next level, during the setup
    std::vector<double> m_factor;  ///< dense Cholesky factor of the last level by rows; empty: that level only smooths
    Phase m_phase = Phase::Done;
    size_t m_row = 0;
    int64_t m_applyWork = 0;
};

}  // namespace rubble
