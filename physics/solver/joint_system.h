#pragma once
#include <span>
#include <utility>
#include <vector>

#include "physics/solver/joint_rows.h"

namespace rubble {

/// Solves the locked rows of all rigid joints at once, by a direct method, so that a chain carries any weight. See
/// joint_system.cpp for the method.
class JointSystem {
public:
    /// Orders the joints for which isInSystem is set and lays out their matrix. If that would be too large, the system
    /// stays empty.
    void build(std::span<const JointRows> joints);
    /// Whether no joint is in the system: then each must be solved by itself.
    bool empty() const { return m_order.empty(); }
    /// Computes the matrix at the joints' current rows and factorizes it.
    void factorize(std::span<const JointRows> joints, std::span<const SolverState> states);
    /// Applies the impulses that correct the velocity of all rows, and adds them to the locked impulses.
    void solve(std::span<JointRows> joints, std::span<SolverState> states, bool useBias);

private:
    void order(std::span<const JointRows> joints);
    void layOutMatrix(std::span<const JointRows> joints);
    void addCoupling(std::span<const JointRows> joints, std::span<const SolverState> states, int p, int q);
    void factorizeRow(int i);
    /// Row i of the matrix, addressed by column.
    double* row(int i) { return &m_matrix[m_rowStart[size_t(i)]] - m_rowFirst[size_t(i)]; }
    template <class F>
    void forEachNeighbour(const JointRows& joint, int number, F&& f) const;

    std::vector<std::pair<int, int>> m_ofBody;  ///< body and joint, sorted
    std::vector<int> m_order;                   ///< the joints in the order of elimination
    std::vector<int> m_position;                ///< of each joint in m_order; -1: it is not there
    std::vector<int> m_offset;                  ///< first matrix row of each joint, by position
    std::vector<std::pair<int, int>> m_pairs;   ///< positions of two joints on one body, the later first
    std::vector<int> m_rowFirst;                ///< first column of each row
    std::vector<size_t> m_rowStart;             ///< of each row in m_matrix
    std::vector<double> m_matrix;               ///< lower triangle by rows (skyline), then L and D in its place
    std::vector<double> m_solution;
};

}  // namespace rubble
