#include "physics/solver_strips.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rubble {
namespace {

constexpr uint32_t kStages = 4;

/// The axis along which these are the farthest from their middle.
int widestAxis(std::span<const SolverBody> bodies, std::span<const std::pair<double, uint32_t>> touching) {
    glm::dvec3 sum(0.0), spread(0.0);
    for (const auto& [place, body] : touching) sum += bodies[body].position;
    const glm::dvec3 middle = sum / double(touching.size());
    for (const auto& [place, body] : touching) spread += glm::abs(bodies[body].position - middle);
    return spread.x >= spread.z ? (spread.x >= spread.y ? 0 : 1) : (spread.z >= spread.y ? 2 : 1);
}

}  // namespace

void SolverStrips::placeBodies(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> pairs, size_t strips) {
    m_strip.assign(bodies.size(), 0);
    for (const auto& [a, b] : pairs) m_strip[size_t(a)] = m_strip[size_t(b)] = 1;
    m_row.clear();
    for (size_t i = 1; i < bodies.size(); ++i)
        if (m_strip[i]) m_row.emplace_back(0.0, uint32_t(i));
    if (m_row.empty()) return;
    const int axis = widestAxis(bodies, m_row);
    for (auto& [place, body] : m_row) place = bodies[body].position[axis];
    std::sort(m_row.begin(), m_row.end());
    for (size_t i = 0; i < m_row.size(); ++i) m_strip[m_row[i].second] = uint32_t(i * strips / m_row.size());
}

void SolverStrips::layOut(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> pairs) {
    m_order.resize(pairs.size());
    std::iota(m_order.begin(), m_order.end(), 0u);
    m_stages.resize(kStages);
    for (std::vector<Task>& stage : m_stages) stage.clear();
    const size_t strips = std::min(pairs.size() / kPairsAStrip, kMostStrips);
    if (strips < 2) {
        if (!pairs.empty()) m_stages[0].push_back({0, pairs.size()});
        return;
    }
    placeBodies(bodies, pairs, strips);
    m_key.clear();
    for (const auto& [a, b] : pairs) {
        const uint32_t s = m_strip[size_t(a ? a : b)], t = m_strip[size_t(b ? b : a)], low = std::min(s, t), apart = std::max(s, t) - low;
        m_key.push_back(apart == 0 ? low : apart == 1 ? (1 + low % 2) * kMostStrips + low : (kStages - 1) * kMostStrips);
    }
    std::sort(m_order.begin(), m_order.end(), [&](uint32_t p, uint32_t q) { return m_key[p] != m_key[q] ? m_key[p] < m_key[q] : p < q; });
    for (size_t from = 0, to = 0; from < m_order.size(); from = to) {
        const uint32_t key = m_key[m_order[from]];
        while (to < m_order.size() && m_key[m_order[to]] == key) ++to;
        m_stages[key / kMostStrips].push_back({from, to});
    }
}

void SolverStrips::run(const ParallelFor* parallelFor, const std::function<void(size_t, size_t)>& body) const {
    for (const std::vector<Task>& stage : m_stages) {
        const auto runTask = [&stage, &body](size_t i) { body(stage[i].from, stage[i].to); };
        if (parallelFor && stage.size() > 1)
            (*parallelFor)(stage.size(), runTask);
        else
            serialFor(stage.size(), runTask);
    }
}

}  // namespace rubble
