#include "runtime/assets/vdb/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>
#include <set>
#include <utility>

namespace rubble {
namespace {

using Edge = std::pair<uint32_t, uint32_t>;

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

/// The edges that an odd number of triangles have.
std::vector<Edge> openEdges(const Mesh& mesh) {
    std::vector<Edge> edges;
    for (const MeshTriangle& triangle : mesh.triangles)
        for (size_t c = 0; c < 3; ++c) {
            const uint32_t a = triangle.points[c], b = triangle.points[(c + 1) % 3];
            edges.emplace_back(std::min(a, b), std::max(a, b));
        }
    std::sort(edges.begin(), edges.end());
    std::vector<Edge> open;
    for (auto at = edges.begin(); at != edges.end();) {
        const auto next = std::find_if(at, edges.end(), [&](const Edge& edge) { return edge != *at; });
        if ((next - at) % 2 != 0) open.push_back(*at);
        at = next;
    }
    return open;
}

}  // namespace

MeshParts findParts(const Mesh& mesh) {
    Union parts(mesh.points.size());
    for (const MeshTriangle& triangle : mesh.triangles) {
        parts.join(triangle.points[0], triangle.points[1]);
        parts.join(triangle.points[1], triangle.points[2]);
    }
    MeshParts out;
    std::set<uint32_t> all, open;
    for (const Edge& edge : openEdges(mesh)) {
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
