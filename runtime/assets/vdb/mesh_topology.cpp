#include "runtime/assets/vdb/mesh_topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <set>
#include <span>
#include <utility>

namespace rubble {
namespace {

/// Two points, and how much more often triangles go from the first to the second than back.
struct Edge {
    uint32_t first, second;
    int net;
};

/// Sets of points that grow together.
class Union {
public:
    explicit Union(size_t count) : m_parents(count) { std::iota(m_parents.begin(), m_parents.end(), 0u); }
    uint32_t find(uint32_t each) {
        while (m_parents[each] != each) each = m_parents[each] = m_parents[m_parents[each]];
        return each;
    }
    void join(uint32_t a, uint32_t b) { m_parents[find(a)] = find(b); }

private:
    std::vector<uint32_t> m_parents;
};

/// The edges that triangles do not go along as often one way as the other: all open ones are among them.
std::vector<Edge> unmatchedEdges(const Mesh& mesh) {
    std::vector<Edge> edges;
    for (const MeshTriangle& triangle : mesh.triangles)
        for (size_t c = 0; c < 3; ++c) {
            const uint32_t a = triangle.points[c], b = triangle.points[(c + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
        }
    const auto pointsOf = [](const Edge& edge) { return std::pair(edge.first, edge.second); };
    std::ranges::sort(edges, {}, pointsOf);
    std::vector<Edge> unmatched;
    for (auto at = edges.begin(); at != edges.end();) {
        Edge all = *at;
        for (++at; at != edges.end() && pointsOf(*at) == pointsOf(all); ++at) all.net += at->net;
        if (all.net != 0) unmatched.push_back(all);
    }
    return unmatched;
}

/// An unmatched edge on its line.
struct Span {
    Edge edge;                     ///< net: along the direction of the line
    std::array<double, 6> line;    ///< direction and moment (Pluecker coordinates): equal for edges on one line
    double low = 0.0, high = 0.0;  ///< along it
};

Span spanOf(const Mesh& mesh, Edge edge) {
    constexpr double kLeast = 0.43;  // less than one component at least, and of no common angle
    const glm::dvec3 origin = mesh.points.front();
    const glm::dvec3 a = mesh.points[edge.first] - origin, b = mesh.points[edge.second] - origin;
    glm::dvec3 along = glm::normalize(b - a);
    const glm::dvec3 size = glm::abs(along);
    const int axis = size.x > kLeast ? 0 : size.y > kLeast ? 1 : 2;
    if (along[axis] < 0.0) along = -along, edge.net = -edge.net;
    const glm::dvec3 moment = glm::cross(a, along);
    const double at = glm::dot(a, along), to = glm::dot(b, along);
    return {edge, {along.x, along.y, along.z, moment.x, moment.y, moment.z}, std::min(at, to), std::max(at, to)};
}

/// What is left of unmatched edges where those on the same line are taken together: seams, where long edges meet
/// several short ones, are none.
class Seams {
public:
    std::vector<Edge> open;  ///< somewhere an odd number of triangles meet
    bool isTwisted = false;  ///< somewhere an even number does, but not as many each way

    Seams(const Mesh& mesh, const std::vector<Edge>& edges) {
        constexpr double kTurn = 1e-4, kShare = 1e-5;  // of the extent
        glm::dvec3 low = mesh.points.front(), high = low;
        for (const glm::dvec3& each : mesh.points) low = glm::min(low, each), high = glm::max(high, each);
        const double apart = kShare * glm::length(high - low);
        m_gaps = {kTurn, kTurn, kTurn, apart, apart, apart};
        std::vector<Span> spans;
        for (const Edge& each : edges) spans.push_back(spanOf(mesh, each));
        addSpans(spans, 0);
    }

private:
    /// Splits them at gaps of a number of their lines, then at those of the next number, until they are on one line.
    void addSpans(std::span<Span> spans, size_t number) {
        if (number == m_gaps.size()) return addLine(spans);
        std::ranges::sort(spans, {}, [=](const Span& each) { return each.line[number]; });
        for (size_t begin = 0, end = 1; begin < spans.size(); begin = end++) {
            while (end < spans.size() && spans[end].line[number] - spans[end - 1].line[number] <= m_gaps[number]) ++end;
            addSpans(spans.subspan(begin, end - begin), number + 1);
        }
    }

    void addLine(std::span<Span> line) {
        std::vector<std::pair<double, int>> ends;
        for (const Span& each : line)
            ends.emplace_back(each.low, each.edge.net), ends.emplace_back(each.high, -each.edge.net);
        std::ranges::sort(ends);
        std::vector<std::pair<double, double>> odd;
        int net = 0;
        for (size_t i = 0; i + 1 < ends.size(); ++i) {
            net += ends[i].second;
            if (net == 0 || ends[i + 1].first - ends[i].first <= m_gaps.back()) continue;
            if (net % 2 != 0)
                odd.emplace_back(ends[i].first, ends[i + 1].first);
            else
                isTwisted = true;
        }
        for (const Span& each : line) {
            if (each.edge.net % 2 == 0) continue;
            const auto last = std::ranges::lower_bound(odd, each.high, {}, &std::pair<double, double>::first);
            if (last != odd.begin() && std::prev(last)->second > each.low) open.push_back(each.edge);
        }
    }

    std::array<double, 6> m_gaps{};
};

}  // namespace

MeshParts findParts(const Mesh& mesh) {
    Union parts(mesh.points.size());
    for (const MeshTriangle& triangle : mesh.triangles) {
        parts.join(triangle.points[0], triangle.points[1]);
        parts.join(triangle.points[1], triangle.points[2]);
    }
    MeshParts out;
    std::set<uint32_t> all, open;
    const Seams seams(mesh, unmatchedEdges(mesh));
    out.isTurnedAlike = !seams.isTwisted;
    for (const Edge& edge : seams.open) {
        ++out.openEdges;
        open.insert(parts.find(edge.first));
    }
    for (const MeshTriangle& triangle : mesh.triangles) {
        const uint32_t part = parts.find(triangle.points[0]);
        all.insert(part);
        out.isOpen.push_back(open.contains(part));
    }
    out.count = all.size();
    out.open = open.size();
    return out;
}

double volumeOf(const Mesh& mesh, const std::vector<bool>& isLeftOut) {
    const glm::dvec3 origin = mesh.points.front();
    double six = 0.0;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (isLeftOut[i]) continue;
        const auto& p = mesh.triangles[i].points;
        six += glm::dot(mesh.points[p[0]] - origin, glm::cross(mesh.points[p[1]] - origin, mesh.points[p[2]] - origin));
    }
    return std::abs(six) / 6.0;
}

}  // namespace rubble
