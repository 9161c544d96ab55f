#include "physics/solver/joint_system.h"

#include <algorithm>

// All rigid joints at once.
//
// Let J be the Jacobian of all locked rows and b the change of velocity that they need. The impulses x that make it
// solve (J M^-1 J^T) x = b. Gauss-Seidel needs as many iterations as a chain has links to carry a load from end to end;
// a direct method needs none. The matrix is sparse: two joints are coupled only if they share a body. Numbered breadth
// first along the bodies (Cuthill and McKee, "Reducing the bandwidth of sparse symmetric matrices", 1969), its entries
// lie near the diagonal, so it is stored as a skyline, each row from its first nonzero column. L D L^T keeps that
// profile, and costs a chain time linear in its length (compare Baraff, "Linear-Time Dynamics using Lagrange
// Multipliers", SIGGRAPH 1996, which needs trees; here loops are exact too). A pivot that vanishes belongs to a
// redundant row, which other rows imply: it gets no impulse.

namespace rubble {
namespace {

constexpr size_t kMaxMatrixEntries = 200'000;  ///< with more, joints are solved one after the other
constexpr double kRedundantPivot = 1e-9;       ///< fraction of a row's diagonal below which its pivot counts as 0

}  // namespace

template <class F>
void JointSystem::forEachNeighbour(const JointRows& joint, int number, F&& f) const {
    for (const int body : joint.c->bodies) {
        if (!body) continue;
        for (auto at = std::lower_bound(m_ofBody.begin(), m_ofBody.end(), std::pair(body, 0));
             at != m_ofBody.end() && at->first == body; ++at)
            if (at->second != number) f(at->second);
    }
}

void JointSystem::build(std::span<const JointRows> joints) {
    order(joints);
    layOutMatrix(joints);
}

/// Breadth first through each group of joints that share bodies.
void JointSystem::order(std::span<const JointRows> joints) {
    m_order.clear();
    m_ofBody.clear();
    m_position.assign(joints.size(), -1);
    for (size_t i = 0; i < joints.size(); ++i) {
        if (!joints[i].isInSystem) continue;
        for (const int body : joints[i].c->bodies)
            if (body) m_ofBody.emplace_back(body, int(i));
    }
    std::sort(m_ofBody.begin(), m_ofBody.end());
    for (size_t first = 0; first < joints.size(); ++first) {
        if (!joints[first].isInSystem || m_position[first] >= 0) continue;
        size_t next = m_order.size();
        m_position[first] = int(next);
        m_order.push_back(int(first));
        for (; next < m_order.size(); ++next) {
            const int number = m_order[next];
            forEachNeighbour(joints[size_t(number)], number, [&](int other) {
                if (m_position[size_t(other)] >= 0) return;
                m_position[size_t(other)] = int(m_order.size());
                m_order.push_back(other);
            });
        }
    }
}

void JointSystem::layOutMatrix(std::span<const JointRows> joints) {
    m_pairs.clear();
    m_rowStart.clear();
    m_rowFirst.clear();
    m_offset.clear();
    size_t entries = 0;
    for (size_t p = 0; p < m_order.size(); ++p) {
        m_offset.push_back(int(m_rowFirst.size()));
        int first = int(p);
        const JointRows& joint = joints[size_t(m_order[p])];
        forEachNeighbour(joint, m_order[p], [&](int other) {
            const int q = m_position[size_t(other)];
            if (q >= int(p)) return;
            first = std::min(first, q);
            m_pairs.emplace_back(int(p), q);
        });
        for (int r = 0; r < joint.rows; ++r) {
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

void JointSystem::factorize(std::span<const JointRows> joints, std::span<const SolverState> states) {
    if (m_order.empty()) return;
    std::fill(m_matrix.begin(), m_matrix.end(), 0.0);
    for (int p = 0; p < int(m_order.size()); ++p) addCoupling(joints, states, p, p);
    for (const auto& [p, q] : m_pairs) addCoupling(joints, states, p, q);
    for (int i = 0; i < int(m_rowFirst.size()); ++i) factorizeRow(i);
}

/// Adds to J M^-1 J^T what the joints at two positions have in common: the bodies that both join.
void JointSystem::addCoupling(std::span<const JointRows> joints, std::span<const SolverState> states, int p, int q) {
    const JointRows &e = joints[size_t(m_order[size_t(p)])], &f = joints[size_t(m_order[size_t(q)])];
    for (size_t side = 0; side < 2; ++side)
        for (size_t otherSide = 0; otherSide < 2; ++otherSide) {
            const int body = e.c->bodies[side];
            if (!body || body != f.c->bodies[otherSide]) continue;
            const SolverState& state = states[size_t(body)];
            const glm::dmat3 inverseInertia(state.inverseInertia);
            const double sign = side == otherSide ? 1.0 : -1.0, inverseMass = sign * double(state.inverseMass);
            for (int r = 0; r < e.rows; ++r) {
                const JointRow& own = e.row[size_t(r)];
                const glm::dvec3 angular = (inverseInertia * (side ? own.angularB : own.angularA)) * sign;
                const glm::dvec3 linear = (side ? own.linearB : own.linearA) * inverseMass;
                double* entries = row(m_offset[size_t(p)] + r) + m_offset[size_t(q)];
                for (int s = 0; s < (p == q ? r + 1 : f.rows); ++s) {
                    const JointRow& other = f.row[size_t(s)];
                    entries[s] += glm::dot(linear, otherSide ? other.linearB : other.linearA) +
                                  glm::dot(angular, otherSide ? other.angularB : other.angularA);
                }
            }
        }
}

void JointSystem::factorizeRow(int i) {
    double* own = row(i);
    const int first = m_rowFirst[size_t(i)];
    const double diagonal = own[i];
    for (int j = first; j < i; ++j) {  // own[j] becomes L D
        const double* above = row(j);
        double sum = own[j];
        for (int k = std::max(first, m_rowFirst[size_t(j)]); k < j; ++k) sum -= own[k] * above[k];
        own[j] = sum;
    }
    for (int j = first; j < i; ++j) {
        const double d = row(j)[j], l = d > 0.0 ? own[j] / d : 0.0;
        own[i] -= own[j] * l;
        own[j] = l;
    }
    if (!(own[i] > kRedundantPivot * diagonal)) own[i] = 0.0;
}

void JointSystem::solve(std::span<JointRows> joints, std::span<SolverState> states, bool useBias) {
    if (m_order.empty()) return;
    for (size_t p = 0; p < m_order.size(); ++p) {
        const JointRows& e = joints[size_t(m_order[p])];
        for (int r = 0; r < e.rows; ++r)
            m_solution[size_t(m_offset[p] + r)] = velocityError(e, r, e.stateA(states), e.stateB(states), useBias);
    }
    const int rows = int(m_rowFirst.size());
    for (int i = 0; i < rows; ++i) {
        const double* own = row(i);
        for (int k = m_rowFirst[size_t(i)]; k < i; ++k) m_solution[size_t(i)] -= own[k] * m_solution[size_t(k)];
    }
    for (int i = 0; i < rows; ++i) {
        const double d = row(i)[i];
        m_solution[size_t(i)] = d > 0.0 ? m_solution[size_t(i)] / d : 0.0;
    }
    for (int i = rows; i-- > 0;) {
        const double* own = row(i);
        for (int k = m_rowFirst[size_t(i)]; k < i; ++k) m_solution[size_t(k)] -= own[k] * m_solution[size_t(i)];
    }
    for (size_t p = 0; p < m_order.size(); ++p) {
        const JointRows& e = joints[size_t(m_order[p])];
        for (int r = 0; r < e.rows; ++r) {
            const double impulse = m_solution[size_t(m_offset[p] + r)];
            e.row[size_t(r)].apply(e.stateA(states), e.stateB(states), impulse);
            e.c->lockedImpulse[size_t(r)] += impulse;
        }
    }
}

}  // namespace rubble
