#include "runtime/destruction/stress_multigrid.h"

#include <cmath>
#include <utility>

// Algebraic multigrid by smoothed aggregation (P. Vanek, J. Mandel and M. Brezina, "Algebraic multigrid by smoothed
// aggregation for second and fourth order elliptic problems", Computing 56, 1996).
//
// Gauss-Seidel removes the errors that bend bonds strongly in a few passes, but hardly those in which large parts of
// the structure move almost like rigid bodies. Such errors are represented on a coarser level. There, strongly coupled
// nodes form an aggregate, and an aggregate is a rigid body with six degrees of freedom again:
//   * T maps the motion of an aggregate to that of its nodes; it holds the rigid body modes exactly.
//   * P = (1 - w D^-1 A) T is one Jacobi step on T: it lowers the energy at the borders of the aggregates.
//   * The coarse matrix is P^T A P (Galerkin). Coarsening repeats until a level is small enough for a dense Cholesky.
// One V-cycle: a forward Gauss-Seidel pass, the correction of the coarse level for the residual P^T (r - A x), a
// backward pass. Both passes together are symmetric, as the preconditioner of conjugate gradients must be.

namespace rubble {
namespace {

constexpr size_t kDenseNodes = 20;      ///< a level of at most this many nodes is solved directly
constexpr double kSmoothing = 2.0 / 3;  ///< w = 4/3 / lambda, lambda <= 2 being the largest eigenvalue of D^-1 A
constexpr double kStrong = 0.02;        ///< relative coupling from which two nodes may share an aggregate
constexpr uint32_t kNoAggregate = ~0u;

/// A measure of a block's stiffness that does not depend on the axes: the trace for translations.
double stiffnessOf(const Block6& block) {
    return std::fabs(block.at(0, 0) + block.at(1, 1) + block.at(2, 2));
}

/// Block Gauss-Seidel on one row of a x = r.
void relax(const BlockMatrix& a, const std::vector<Block6>& inverse, const std::vector<Vector6>& r,
           std::vector<Vector6>& x, size_t row) {
    Vector6 sum = r[row];
    for (uint32_t i = a.start[row]; i < a.start[row + 1]; ++i)
        if (a.column[i] != row) subtractProduct(sum, a.block[i], x[a.column[i]]);
    x[row] = product(inverse[row], sum);
}

}  // namespace

void StressMultigrid::begin(BlockMatrix stiffness, std::vector<glm::dvec3> centers) {
    m_levels.clear();
    m_factor.clear();
    m_applyWork = 0;
    Level& level = m_levels.emplace_back();
    level.a = std::move(stiffness);
    level.center = std::move(centers);
    enter(level.a.rows() ? Phase::Diagonal : Phase::Done);
}

bool StressMultigrid::setUp(int64_t& work) {
    while (m_phase != Phase::Done && work > 0) stepRow(work);
    return m_phase == Phase::Done;
}

/// The next row of the setup, or a step between two phases.
void StressMultigrid::stepRow(int64_t& work) {
    Level& level = m_levels.back();
    const size_t rows = m_phase == Phase::Coarse ? level.aggregates : level.a.rows();
    constexpr int64_t kBlockProduct = 12, kBlockInverse = 40, kBlockCopy = 4;
    switch (m_phase) {
        case Phase::Diagonal:
            level.inverse.push_back(inverted(level.a.diagonal(m_row)));
            work -= kBlockInverse;
            if (++m_row == rows) work -= nextLevel();
            return;
        case Phase::Aggregate:
            aggregate(level);
            work -= int64_t(rows + level.a.block.size());
            level.p.block.reserve(level.a.block.size());
            enter(Phase::Prolongation);
            return;
        case Phase::Prolongation:
            appendProlongationRow(level, m_row);
            work -= kBlockProduct * int64_t(2 * (level.a.start[m_row + 1] - level.a.start[m_row]));
            if (++m_row < rows) return;
            level.restriction = transposed(level.p, level.aggregates);
            work -= kBlockCopy * int64_t(level.p.block.size());
            level.ap.block.reserve(2 * level.a.block.size());
            enter(Phase::Product);
            return;
        case Phase::Product:
            work -= kBlockProduct * int64_t(appendProductRow(level.ap, level.a, level.p, m_row));
            if (++m_row < rows) return;
            m_coarse.block.reserve(level.p.block.size());
            enter(Phase::Coarse);
            return;
        case Phase::Coarse:
            work -= kBlockProduct * int64_t(appendProductRow(m_coarse, level.restriction, level.ap, m_row));
            if (++m_row < rows) return;
            addCoarseLevel();
            enter(Phase::Diagonal);
            return;
        case Phase::Done:
            return;
    }
}

void StressMultigrid::addCoarseLevel() {
    Level& level = m_levels.back();
    Level next;
    next.a = std::exchange(m_coarse, {});
    next.center = level.coarseCenter;
    level.ap = {};
    m_levels.push_back(std::move(next));
}

/// After the diagonal of a level: coarsens further, or factors the level and ends. Returns the work.
int64_t StressMultigrid::nextLevel() {
    Level& level = m_levels.back();
    const size_t rows = level.a.rows();
    level.x.resize(rows), level.r.resize(rows), level.rest.resize(rows);
    m_applyWork += int64_t(3 * level.a.block.size() + 4 * rows);
    if (rows > kDenseNodes) {
        const bool hasStalled = m_levels.size() > 1 && rows * 10 > m_levels[m_levels.size() - 2].a.rows() * 9;
        enter(hasStalled ? Phase::Done : Phase::Aggregate);
        return int64_t(rows);
    }
    factor(level.a);
    enter(Phase::Done);
    return int64_t(rows * rows * rows);  // (6 n)^3 / 6 operations, 36 in a block product
}

/// Greedy aggregation: first each node whose strong neighbours are all free takes them; then each node that is left
/// joins the aggregate of its strongest neighbour.
void StressMultigrid::aggregate(Level& level) {
    const BlockMatrix& a = level.a;
    const size_t n = a.rows();
    std::vector<double> own(n);
    for (size_t i = 0; i < n; ++i) own[i] = stiffnessOf(a.diagonal(i));
    const auto strength = [&](size_t row, uint32_t entry) {
        const double coupling = stiffnessOf(a.block[entry]);
        return a.column[entry] == row ? 0.0 : coupling * coupling / (own[row] * own[a.column[entry]]);
    };
    level.aggregate.assign(n, kNoAggregate);
    uint32_t count = 0;
    for (size_t i = 0; i < n; ++i) {
        bool isFree = level.aggregate[i] == kNoAggregate;
        for (uint32_t e = a.start[i]; isFree && e < a.start[i + 1]; ++e)
            isFree = level.aggregate[a.column[e]] == kNoAggregate || strength(i, e) < kStrong * kStrong;
        if (!isFree) continue;
        level.aggregate[i] = count;
        for (uint32_t e = a.start[i]; e < a.start[i + 1]; ++e)
            if (strength(i, e) >= kStrong * kStrong) level.aggregate[a.column[e]] = count;
        ++count;
    }
    const std::vector<uint32_t> seeds = level.aggregate;
    for (size_t i = 0; i < n; ++i) {
        if (seeds[i] != kNoAggregate) continue;
        double strongest = 0.0;
        for (uint32_t e = a.start[i]; e < a.start[i + 1]; ++e)
            if (seeds[a.column[e]] != kNoAggregate && strength(i, e) > strongest)
                strongest = strength(i, e), level.aggregate[i] = seeds[a.column[e]];
        if (level.aggregate[i] == kNoAggregate) level.aggregate[i] = count++;
    }
    level.aggregates = count;
    level.coarseCenter.assign(count, glm::dvec3(0.0));
    std::vector<double> members(count);
    for (size_t i = 0; i < n; ++i)
        level.coarseCenter[level.aggregate[i]] += level.center[i], members[level.aggregate[i]] += 1.0;
    for (size_t i = 0; i < count; ++i) level.coarseCenter[i] /= members[i];
}

/// A row of P = (1 - w D^-1 A) T.
void StressMultigrid::appendProlongationRow(Level& level, size_t row) {
    const BlockMatrix& a = level.a;
    Block6 scaled = level.inverse[row];
    for (double& value : scaled.m) value *= -kSmoothing;
    const auto rigid = [&](uint32_t node) {
        return rigidBlock(level.center[node] - level.coarseCenter[level.aggregate[node]]);
    };
    level.p.findOrAppend(level.aggregate[row]) = rigid(uint32_t(row));
    for (uint32_t e = a.start[row]; e < a.start[row + 1]; ++e) {
        Block6 at;
        addProduct(at, a.block[e], rigid(a.column[e]));
        addProduct(level.p.findOrAppend(level.aggregate[a.column[e]]), scaled, at);
    }
    level.p.endRow();
}

/// Dense Cholesky factorisation of the last level.
void StressMultigrid::factor(const BlockMatrix& a) {
    const size_t n = a.rows() * 6;
    m_factor.assign(n * n, 0.0);
    for (size_t row = 0; row < a.rows(); ++row)
        for (uint32_t e = a.start[row]; e < a.start[row + 1]; ++e)
            for (size_t r = 0; r < 6; ++r)
                for (size_t c = 0; c < 6; ++c) m_factor[(row * 6 + r) * n + a.column[e] * 6 + c] = a.block[e].at(r, c);
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j) {
            double sum = m_factor[i * n + j];
            for (size_t k = 0; k < j; ++k) sum -= m_factor[i * n + k] * m_factor[j * n + k];
            m_factor[i * n + j] = i != j      ? sum / m_factor[j * n + j]
                                  : sum > 0.0 ? std::sqrt(sum)
                                              : 1e150;  // a node without stiffness does not move
        }
}

void StressMultigrid::solveCoarsest(const std::vector<Vector6>& r, std::vector<Vector6>& x) const {
    const size_t n = r.size() * 6;
    for (size_t i = 0; i < n; ++i) {
        double sum = r[i / 6][i % 6];
        for (size_t k = 0; k < i; ++k) sum -= m_factor[i * n + k] * x[k / 6][k % 6];
        x[i / 6][i % 6] = sum / m_factor[i * n + i];
    }
    for (size_t i = n; i-- > 0;) {
        double sum = x[i / 6][i % 6];
        for (size_t k = i + 1; k < n; ++k) sum -= m_factor[k * n + i] * x[k / 6][k % 6];
        x[i / 6][i % 6] = sum / m_factor[i * n + i];
    }
}

/// x = approximate inverse times r on a level, by one V-cycle from there down.
void StressMultigrid::cycle(size_t index) {
    Level& level = m_levels[index];
    const size_t n = level.a.rows();
    if (index + 1 == m_levels.size() && !m_factor.empty()) {
        solveCoarsest(level.r, level.x);
        return;
    }
    for (Vector6& x : level.x) x = {};
    for (size_t i = 0; i < n; ++i) relax(level.a, level.inverse, level.r, level.x, i);
    if (index + 1 < m_levels.size()) {
        Level& coarse = m_levels[index + 1];
        multiply(level.a, level.x, level.rest);
        for (size_t i = 0; i < n; ++i)
            for (size_t k = 0; k < 6; ++k) level.rest[i][k] = level.r[i][k] - level.rest[i][k];
        multiply(level.restriction, level.rest, coarse.r);
        cycle(index + 1);
        for (size_t i = 0; i < n; ++i)
            for (uint32_t e = level.p.start[i]; e < level.p.start[i + 1]; ++e)
                addProduct(level.x[i], level.p.block[e], coarse.x[level.p.column[e]]);
    }
    for (size_t i = n; i-- > 0;) relax(level.a, level.inverse, level.r, level.x, i);
}

void StressMultigrid::apply(const std::vector<Vector6>& r, std::vector<Vector6>& z) {
    if (m_levels.front().a.rows() == 0) return;
    m_levels.front().r = r;
    cycle(0);
    z = m_levels.front().x;
}

}  // namespace rubble
