#include "physics/solver/constraint_coloring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace rubble {
namespace {

constexpr uint32_t kColors = 4;

/// The axis along which the bodies have the largest mean distance from their centroid.
int widestAxis(std::span<const SolverBody> bodies, std::span<const std::pair<double, uint32_t>> constrained) {
    glm::dvec3 sum(0.0), spread(0.0);
    for (const auto& [coordinate, body] : constrained) sum += bodies[body].position;
    const glm::dvec3 centroid = sum / double(constrained.size());
    for (const auto& [coordinate, body] : constrained) spread += glm::abs(bodies[body].position - centroid);
    return spread.x >= spread.z ? (spread.x >= spread.y ? 0 : 1) : (spread.z >= spread.y ? 2 : 1);
}

}  // namespace

/// Sorts the constrained bodies along the widest axis and divides them into strips.
void ConstraintColoring::assignStrips(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> pairs,
                                      size_t strips) {
    m_strip.assign(bodies.size(), 0);
    for (const auto& [a, b] : pairs) m_strip[size_t(a)] = m_strip[size_t(b)] = 1;
    m_sortedBodies.clear();
    for (size_t i = 1; i < bodies.size(); ++i)
        if (m_strip[i]) m_sortedBodies.emplace_back(0.0, uint32_t(i));
    if (m_sortedBodies.empty()) return;
    const int axis = widestAxis(bodies, m_sortedBodies);
    for (auto& [coordinate, body] : m_sortedBodies) coordinate = bodies[body].position[axis];
    std::sort(m_sortedBodies.begin(), m_sortedBodies.end());
    for (size_t i = 0; i < m_sortedBodies.size(); ++i)
        m_strip[m_sortedBodies[i].second] = uint32_t(i * strips / m_sortedBodies.size());
}

void ConstraintColoring::build(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> pairs) {
    m_order.resize(pairs.size());
    m_colors.resize(kColors);
    for (std::vector<Task>& color : m_colors) color.clear();
    const size_t strips = std::min(pairs.size() / kPairsPerStrip, kMaxStrips);
    if (strips < 2) {
        std::iota(m_order.begin(), m_order.end(), 0u);
        if (!pairs.empty()) m_colors[0].push_back({0, pairs.size()});
        return;
    }
    assignStrips(bodies, pairs, strips);
    m_key.clear();
    std::array<size_t, size_t(kColors) * kMaxStrips + 1> ends{};  // of the pairs of each key
    for (const auto& [a, b] : pairs) {
        const uint32_t s = m_strip[size_t(a ? a : b)], t = m_strip[size_t(b ? b : a)], low = std::min(s, t),
                       apart = std::max(s, t) - low;
        m_key.push_back(apart == 0 ? low : apart == 1 ? (1 + low % 2) * kMaxStrips + low : (kColors - 1) * kMaxStrips);
        ++ends[m_key.back() + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    for (uint32_t i = 0; i < pairs.size(); ++i) m_order[ends[m_key[i]]++] = i;
    for (size_t key = 0, from = 0; key + 1 < ends.size(); from = ends[key++])
        if (ends[key] > from) m_colors[key / kMaxStrips].push_back({from, ends[key]});
}

void ConstraintColoring::replaceRanges(const std::function<std::pair<size_t, size_t>(size_t, size_t)>& f) {
    for (std::vector<Task>& color : m_colors)
        for (Task& task : color) std::tie(task.from, task.to) = f(task.from, task.to);
}

void ConstraintColoring::run(const ParallelFor* parallelFor, const std::function<void(size_t, size_t)>& body) const {
    for (const std::vector<Task>& color : m_colors) {
        const auto runTask = [&color, &body](size_t i) { body(color[i].from, color[i].to); };
        size_t count = 0;
        for (const Task& task : color) count += task.to - task.from;
        if (parallelFor && color.size() > 1 && count >= kMinParallelItems)
            (*parallelFor)(color.size(), runTask);
        else
            serialFor(color.size(), runTask);
    }
}

}  // namespace rubble
