#include <algorithm>

#include "physics/solver/joint_solver.h"

namespace rubble {
namespace {

constexpr size_t kMaxMatrixEntries = 200'000;  ///< of the matrix; with more, all joints are solved one after the other
constexpr double kRedundantPivot = 1e-9;       ///< share of a direction's own mass below which others already hold it

}  // namespace

/// Orders the rigid joints so that those which share a body are near each other, and lays out the matrix of their
/// directions by rows, each from the first joint that it is coupled with: for a chain that is linear in its length,
/// with loops too it is exact.
void JointSolver::buildSystem() {
    m_order.clear();
    m_pairs.clear();
    std::vector<std::pair<int, int>> ofBody;  // body and joint
    std::vector<int> position(m_joints.size(), -1);
    for (size_t i = 0; i < m_joints.size(); ++i) {
        if (!m_joints[i].isInSystem) continue;
        for (const int body : m_joints[i].c->bodies)
            if (body) ofBody.emplace_back(body, int(i));
    }
    std::sort(ofBody.begin(), ofBody.end());
    const auto forEachNeighbour = [&](int joint, auto&& f) {
        for (const int body : m_joints[size_t(joint)].c->bodies) {
            if (!body) continue;
            for (auto at = std::lower_bound(ofBody.begin(), ofBody.end(), std::pair(body, 0));
                 at != ofBody.end() && at->first == body; ++at)
                if (at->second != joint) f(at->second);
        }
    };
    for (size_t first = 0; first < m_joints.size(); ++first) {  // breadth first through all that hangs together
        if (!m_joints[first].isInSystem || position[first] >= 0) continue;
        size_t next = m_order.size();
        position[first] = int(next);
        m_order.push_back(int(first));
        for (; next < m_order.size(); ++next)
            forEachNeighbour(m_order[next], [&](int other) {
                if (position[size_t(other)] >= 0) return;
                position[size_t(other)] = int(m_order.size());
                m_order.push_back(other);
            });
    }
    m_rowStart.clear();
    m_rowFirst.clear();
    m_offset.clear();
    size_t entries = 0;
    for (size_t p = 0; p < m_order.size(); ++p) {
        m_offset.push_back(int(m_rowFirst.size()));
        int first = int(p);
        forEachNeighbour(m_order[p], [&](int other) {
            const int q = position[size_t(other)];
            if (q >= int(p)) return;
            first = std::min(first, q);
            m_pairs.emplace_back(int(p), q);
        });
        const Entry& e = m_joints[size_t(m_order[p])];
        for (int r = 0; r < e.rows; ++r) {
            m_rowFirst.push_back(m_offset[size_t(first)]);
            m_rowStart.push_back(entries);
            entries += size_t(m_offset[p] + r - m_offset[size_t(first)] + 1);
        }
    }
    std::sort(m_pairs.begin(), m_pairs.end());
    m_pairs.erase(std::unique(m_pairs.begin(), m_pairs.end()), m_pairs.end());
    if (entries > kMaxMatrixEntries) m_order.clear();
    m_matrix.resize(m_order.empty() ? 0 : entries);
    m_solution.resize(m_rowFirst.size());
}

/// The matrix J M^-1 J^T, and its L D L^T in its place.
void JointSolver::factorizeSystem(std::span<const SolverState> states) {
    if (m_order.empty()) return;
    std::fill(m_matrix.begin(), m_matrix.end(), 0.0);
    const auto at = [&](int i, int j) -> double& {
        return m_matrix[m_rowStart[size_t(i)] + size_t(j - m_rowFirst[size_t(i)])];
    };
    const auto couple = [&](int p, int q) {
        const Entry &e = m_joints[size_t(m_order[size_t(p)])], &f = m_joints[size_t(m_order[size_t(q)])];
        for (size_t side = 0; side < 2; ++side)
            for (size_t other = 0; other < 2; ++other) {
                const int body = e.c->bodies[side];
                if (!body || body != f.c->bodies[other]) continue;
                const SolverState& state = states[size_t(body)];
                const glm::dmat3 inertia(state.inverseInertia);
                const double sign = side == other ? 1.0 : -1.0, mass = sign * double(state.inverseMass);
                for (int r = 0; r < e.rows; ++r) {
                    const Row& row = e.row[size_t(r)];
                    const glm::dvec3 turn = (inertia * (side ? row.angularB : row.angularA)) * sign;
                    const glm::dvec3 push = (side ? row.linearB : row.linearA) * mass;
                    for (int s = 0; s < (p == q ? r + 1 : f.rows); ++s) {
                        const Row& with = f.row[size_t(s)];
                        at(m_offset[size_t(p)] + r, m_offset[size_t(q)] + s) +=
                            glm::dot(push, other ? with.linearB : with.linearA) +
                            glm::dot(turn, other ? with.angularB : with.angularA);
                    }
                }
            }
    };
    for (int p = 0; p < int(m_order.size()); ++p) couple(p, p);
    for (const auto& [p, q] : m_pairs) couple(p, q);

    for (int i = 0; i < int(m_rowFirst.size()); ++i) {
        double* row = &m_matrix[m_rowStart[size_t(i)]] - m_rowFirst[size_t(i)];
        const double own = row[i];
        for (int j = m_rowFirst[size_t(i)]; j < i; ++j) {  // row[j] becomes L D
            const double* above = &m_matrix[m_rowStart[size_t(j)]] - m_rowFirst[size_t(j)];
            double sum = row[j];
            for (int k = std::max(m_rowFirst[size_t(i)], m_rowFirst[size_t(j)]); k < j; ++k) sum -= row[k] * above[k];
            row[j] = sum;
        }
        for (int j = m_rowFirst[size_t(i)]; j < i; ++j) {
            const double d = at(j, j), l = d > 0.0 ? row[j] / d : 0.0;
            row[i] -= row[j] * l;
            row[j] = l;
        }
        if (!(row[i] > kRedundantPivot * own)) row[i] = 0.0;
    }
}

void JointSolver::solveSystem(std::span<SolverState> states, bool useBias) {
    for (size_t p = 0; p < m_order.size(); ++p) {
        const Entry& e = m_joints[size_t(m_order[p])];
        const SolverState &A = states[size_t(e.c->bodies[0])], &B = states[size_t(e.c->bodies[1])];
        for (int r = 0; r < e.rows; ++r) m_solution[size_t(m_offset[p] + r)] = velocityError(e, r, A, B, useBias);
    }
    const int rows = int(m_rowFirst.size());
    for (int i = 0; i < rows; ++i) {
        const double* row = &m_matrix[m_rowStart[size_t(i)]] - m_rowFirst[size_t(i)];
        for (int k = m_rowFirst[size_t(i)]; k < i; ++k) m_solution[size_t(i)] -= row[k] * m_solution[size_t(k)];
    }
    for (int i = 0; i < rows; ++i) {
        const double d = m_matrix[m_rowStart[size_t(i)] + size_t(i - m_rowFirst[size_t(i)])];
        m_solution[size_t(i)] = d > 0.0 ? m_solution[size_t(i)] / d : 0.0;
    }
    for (int i = rows; i-- > 0;) {
        const double* row = &m_matrix[m_rowStart[size_t(i)]] - m_rowFirst[size_t(i)];
        for (int k = m_rowFirst[size_t(i)]; k < i; ++k) m_solution[size_t(k)] -= row[k] * m_solution[size_t(i)];
    }
    for (size_t p = 0; p < m_order.size(); ++p) {
        Entry& e = m_joints[size_t(m_order[p])];
        SolverState &A = states[size_t(e.c->bodies[0])], &B = states[size_t(e.c->bodies[1])];
        for (int r = 0; r < e.rows; ++r) {
            const double impulse = m_solution[size_t(m_offset[p] + r)];
            push(e.row[size_t(r)], A, B, impulse);
            e.c->lockedImpulse[size_t(r)] += impulse;
        }
    }
}

}  // namespace rubble
