#include "runtime/assets/vdb/mesh_voxels.h"

#include <fmt/format.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <span>

#include "runtime/assets/names.h"
#include "runtime/assets/vdb/fallback_palette.h"
#include "runtime/assets/vdb/mesh_topology.h"
#include "runtime/core/counted.h"

namespace rubble {
namespace {

constexpr double kMaxCells = 1 << 28;
constexpr float kHalfDiagonal = 0.87f;  // of a cell: the surface passes through no cell whose centre is farther away
constexpr int32_t kNoTriangle = -1;
/// In cells, along each axis: so that a surface through centres of cells takes those at one of its sides.
constexpr double kNudge = 1.0 / 64.0;

/// Some triangles of a mesh in cells, whose centres OpenVDB has at whole numbers.
struct MeshInCells {
    const Mesh& mesh;
    const std::vector<glm::dvec3>& points;
    const std::vector<uint32_t>& triangles;

    size_t polygonCount() const { return triangles.size(); }
    size_t pointCount() const { return points.size(); }
    size_t vertexCount(size_t) const { return 3; }
    void getIndexSpacePoint(size_t triangle, size_t corner, openvdb::Vec3d& out) const {
        const glm::dvec3& at = points[mesh.triangles[triangles[triangle]].points[corner]];
        out = {at.x - 0.5, at.y - 0.5, at.z - 0.5};
    }
};

/// The weights of the corners at the point of a triangle that is nearest to a place (Ericson, Real-Time Collision
/// Detection, 5.1.5).
glm::dvec3 nearestWeights(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 place) {
    const glm::dvec3 ab = b - a, ac = c - a, ap = place - a, bp = place - b, cp = place - c;
    const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
                 d6 = dot(ac, cp);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
    const double bc = (d4 - d3) + (d5 - d6);
    if (va <= 0 && d4 >= d3 && d5 >= d6) return {0, 1 - (d4 - d3) / bc, (d4 - d3) / bc};
    const double sum = va + vb + vc;
    if (!(sum > 0)) return {1, 0, 0};  // it has no area
    return {va / sum, vb / sum, vc / sum};
}

// What a cell holds: nothing, a voxel whose colour is not known yet, or this and its sRGB bytes.
constexpr uint32_t kEmpty = 0, kInside = 1u << 25, kColored = 1u << 24;

/// How often closed triangles, turned alike, go around the centres of cells: the crossings of a ray along x through
/// each row of them, in for +1 and out for -1.
class Windings {
public:
    Windings(const Mesh& mesh, const std::vector<glm::dvec3>& points, const std::vector<uint32_t>& triangles,
             glm::ivec3 size)
        : m_size(size) {
        if (triangles.empty()) return;
        m_windings.resize(size_t(size.x) * size_t(size.y) * size_t(size.z));
        for (const uint32_t each : triangles) addCrossings(points, mesh.triangles[each].points);
        for (size_t row = 0; row < m_windings.size(); row += size_t(size.x)) {
            const std::span<int16_t> cells(m_windings.data() + row, size_t(size.x));
            std::partial_sum(cells.begin(), cells.end(), cells.begin());
            if (cells.back() != 0) std::ranges::fill(cells, kUnknown);
        }
    }

    /// Whether the ray of a cell's row ends outside: else a crossing was missed, as in a seam by rounding.
    bool isKnown(glm::ivec3 cell) const { return !m_windings.empty() && m_windings[indexOf(cell)] != kUnknown; }
    /// Whether the triangles go around a cell's centre.
    bool isInside(glm::ivec3 cell) const { return m_windings[indexOf(cell)] != 0; }

private:
    static constexpr int16_t kUnknown = std::numeric_limits<int16_t>::min();

    size_t indexOf(glm::ivec3 cell) const {
        return (size_t(cell.z) * size_t(m_size.y) + size_t(cell.y)) * size_t(m_size.x) + size_t(cell.x);
    }

    /// Twice the signed area of a place with the edge from a to b, along x: exactly the opposite of that from b to a.
    static double areaOf(const std::vector<glm::dvec3>& points, uint32_t a, uint32_t b, glm::dvec2 place) {
        if (a > b) return -areaOf(points, b, a, place);
        const glm::dvec2 from(points[a].y, points[a].z), to(points[b].y, points[b].z);
        return (to.x - from.x) * (place.y - from.y) - (to.y - from.y) * (place.x - from.x);
    }

    void addCrossings(const std::vector<glm::dvec3>& points, const std::array<uint32_t, 3>& corners) {
        const glm::dvec3 &a = points[corners[0]], &b = points[corners[1]], &c = points[corners[2]];
        const auto first = [](double low) { return std::max(int(std::ceil(low - 0.5)), 0); };
        const auto last = [](double high, int size) { return std::min(int(std::floor(high - 0.5)), size - 1); };
        const int lastY = last(std::max({a.y, b.y, c.y}), m_size.y), lastZ = last(std::max({a.z, b.z, c.z}), m_size.z);
        for (int z = first(std::min({a.z, b.z, c.z})); z <= lastZ; ++z)
            for (int y = first(std::min({a.y, b.y, c.y})); y <= lastY; ++y) addCrossing(points, corners, y, z);
    }

    /// A place on an edge belongs to one of the two triangles there.
    void addCrossing(const std::vector<glm::dvec3>& points, const std::array<uint32_t, 3>& corners, int y, int z) {
        const glm::dvec2 place(y + 0.5, z + 0.5);
        double sum = 0.0, x = 0.0;
        int left = 0;
        for (size_t i = 0; i < 3; ++i) {
            const uint32_t from = corners[(i + 1) % 3], to = corners[(i + 2) % 3];
            const double area = areaOf(points, from, to, place);
            left += area > 0.0 || (area == 0.0 && from < to);
            sum += area;
            x += area * points[corners[i]].x;
        }
        if ((left != 0 && left != 3) || sum == 0.0) return;
        const int cell = std::max(int(std::ceil(x / sum - 0.5)), 0);  // the first whose centre is beyond
        if (cell < m_size.x) m_windings[indexOf({cell, y, z})] += left == 3 ? -1 : 1;
    }

    glm::ivec3 m_size;
    std::vector<int16_t> m_windings;
};

/// The cells of a mesh.
class MeshCells {
public:
    MeshCells(const Mesh& mesh, const MeshSettings& settings) : m_mesh(mesh), m_settings(settings) {
        for (const glm::dvec3& each : mesh.points)
            m_points.push_back(settings.isZUp ? glm::dvec3(each.x, each.z, -each.y) : each);
    }

    /// Scales the mesh and finds the grid, whose cells begin at its lowest corner; an error: there is none.
    std::string fit() {
        glm::dvec3 low(std::numeric_limits<double>::max()), high = -low;
        for (const MeshTriangle& triangle : m_mesh.triangles)
            for (const uint32_t point : triangle.points)
                low = glm::min(low, m_points[point]), high = glm::max(high, m_points[point]);
        const glm::dvec3 extent = high - low;
        const double longest = std::max({extent.x, extent.y, extent.z});
        m_scale = m_settings.voxels > 0 ? m_settings.voxels / longest : 1.0 / m_settings.voxelSize;
        const double margin = 1 + m_settings.shell / 2;  // the shell of what is open reaches out
        const glm::dvec3 size = glm::max(glm::ceil(extent * m_scale - kNudge), 1.0) + 2.0 * margin;
        if (!(size.x * size.y * size.z <= kMaxCells && std::max({size.x, size.y, size.z}) <= kMaxGridSize))
            return fmt::format("expected at most {} cells along a side and 2^28 in all, found {:.0f} x {:.0f} x {:.0f}",
                               kMaxGridSize, size.x, size.y, size.z);
        const glm::dvec3 corner = low * m_scale - margin;
        m_corner = corner / m_scale;
        m_size = glm::ivec3(size);
        for (glm::dvec3& each : m_points) each = each * m_scale - corner + kNudge;
        m_cells.assign(size_t(m_size.x) * size_t(m_size.y) * size_t(m_size.z), kEmpty);
        return "";
    }

    /// Fills the inside of closed triangles, or walls as thick as the shell. isTurnedAlike: see MeshParts.
    void addClosed(const std::vector<uint32_t>& triangles, bool isTurnedAlike) {
        const float shell = float(m_settings.shell);
        const Windings windings(m_mesh, m_points, isTurnedAlike ? triangles : std::vector<uint32_t>{}, m_size);
        add(triangles, 0, shell + 2.0f, [&](glm::ivec3 cell, float distance) {
            // Distances alone take gaps of a cell for inside, and concave edges.
            const bool isInside = windings.isKnown(cell) ? windings.isInside(cell) : distance < 0.0f;
            return isInside && (shell == 0.0f || std::abs(distance) < shell);
        });
        if (shell > 0.0f) return;
        for (size_t i = 0; i < m_cells.size(); ++i)
            if (m_cells[i] == kEmpty && windings.isKnown(cellOf(i)) && windings.isInside(cellOf(i)))
                m_cells[i] = kInside;
    }
    /// Fills the cells through which triangles pass that have no inside.
    void addOpen(const std::vector<uint32_t>& triangles) {
        const float half = std::max(kHalfDiagonal, float(m_settings.shell) * 0.5f);
        add(triangles, openvdb::tools::UNSIGNED_DISTANCE_FIELD, half + 1.0f,
            [=](glm::ivec3, float distance) { return distance <= half; });
    }

    /// The shape, with its palette. Cells inside take the colour of the nearest ones at the surface.
    LevelShape shape(ColorCounts& counts) {
        spreadInside();
        LevelShape out;
        out.voxelSize = float(m_settings.voxelSize);
        out.grid = VoxelGrid(m_size);
        out.local.position = m_corner * (m_scale * m_settings.voxelSize);
        GridWriter writer(out.grid);
        for (size_t i = 0; i < m_cells.size(); ++i)
            if (m_cells[i] != kEmpty) writer.set(cellOf(i), 1);
        writer.flush();
        out.palette = quantiseColors(
            out.grid, [this](glm::ivec3 cell) { return m_cells[indexOf(cell)] & (kColored - 1); }, &counts);
        return out;
    }

    /// What a length of the file is multiplied by.
    double scale() const { return m_scale * m_settings.voxelSize; }
    /// Of the grid, in cells.
    glm::ivec3 size() const { return m_size; }

private:
    size_t indexOf(glm::ivec3 cell) const {
        return (size_t(cell.z) * size_t(m_size.y) + size_t(cell.y)) * size_t(m_size.x) + size_t(cell.x);
    }
    glm::ivec3 cellOf(size_t index) const {
        const size_t x = size_t(m_size.x), y = size_t(m_size.y);
        return {int(index % x), int(index / x % y), int(index / (x * y))};
    }

    /// Fills the cells that are wanted by their distance from the surface, negative inside. band: how far it is
    /// computed.
    template <class IsWanted>
    void add(const std::vector<uint32_t>& triangles, int flags, float band, IsWanted isWanted) {
        if (triangles.empty()) return;
        const MeshInCells mesh{m_mesh, m_points, triangles};
        openvdb::Int32Grid nearest(kNoTriangle);
        const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
        const auto grid =
            openvdb::tools::meshToVolume<openvdb::FloatGrid>(mesh, *transform, band, band, flags, &nearest);
        const auto triangleAt = nearest.getConstAccessor();
        const openvdb::CoordBBox all(openvdb::Coord(0), {m_size.x - 1, m_size.y - 1, m_size.z - 1});
        for (auto it = grid->cbeginValueAll(); it; ++it) {
            openvdb::CoordBBox cells;
            it.getBoundingBox(cells);
            cells.intersect(all);
            if (cells.empty()) continue;
            for (auto cell = cells.begin(); cell; ++cell) {
                if (!isWanted(glm::ivec3((*cell).x(), (*cell).y(), (*cell).z()), *it)) continue;
                const int32_t triangle = it.isValueOn() ? triangleAt.getValue(*cell) : kNoTriangle;
                setCell({(*cell).x(), (*cell).y(), (*cell).z()},
                        triangle == kNoTriangle ? kNoTriangle : int32_t(triangles[size_t(triangle)]));
            }
        }
    }

    void setCell(glm::ivec3 cell, int32_t triangle) {
        uint32_t& to = m_cells[indexOf(cell)];
        if (triangle == kNoTriangle) {
            if (to == kEmpty) to = kInside;
            return;
        }
        const MeshTriangle& from = m_mesh.triangles[size_t(triangle)];
        const auto& p = from.points;
        const glm::dvec3 weights =
            nearestWeights(m_points[p[0]], m_points[p[1]], m_points[p[2]], glm::dvec3(cell) + 0.5);
        to = kColored | packSrgb(m_mesh.colorOf(from, weights, m_settings.isSmooth));
    }

    void spreadInside() {
        std::vector<uint32_t> reached;
        for (size_t i = 0; i < m_cells.size(); ++i)
            if (m_cells[i] & kColored) reached.push_back(uint32_t(i));
        for (size_t i = 0; i < reached.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                for (const int step : {-1, 1}) {
                    glm::ivec3 cell = cellOf(reached[i]);
                    cell[axis] += step;
                    if (cell[axis] < 0 || cell[axis] >= m_size[axis] || m_cells[indexOf(cell)] != kInside) continue;
                    m_cells[indexOf(cell)] = m_cells[reached[i]];
                    reached.push_back(uint32_t(indexOf(cell)));
                }
    }

    const Mesh& m_mesh;
    const MeshSettings& m_settings;
    std::vector<glm::dvec3> m_points;  ///< in cells, from the grid's corner
    glm::dvec3 m_corner{0.0};          ///< of the grid, in the file's metres
    double m_scale = 1.0;              ///< cells a metre of the file
    glm::ivec3 m_size{0};
    std::vector<uint32_t> m_cells;
};

/// How well the voxels hold what the mesh encloses.
std::string volumeNote(double mesh, double voxels) {
    std::string note = fmt::format("volume: {:.4g} m3 of voxels for {:.4g} m3 of the mesh", voxels, mesh);
    if (std::abs(voxels - mesh) > 0.05 * mesh)
        note += voxels > mesh ? ": what is thin becomes whole voxels; more voxels come closer"
                              : ": parts thinner than a voxel are lost, and what overlaps counts once; more voxels "
                                "come closer";
    return note;
}

}  // namespace

Result<Level> voxelise(const Mesh& mesh, const std::string& name, const MeshSettings& settings,
                       std::vector<std::string>& notes) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);  // ties depend on threads
    openvdb::initialize();
    MeshCells cells(mesh, settings);
    if (const std::string error = cells.fit(); !error.empty()) return Error{error};
    const MeshParts parts = findParts(mesh);
    std::vector<uint32_t> closed, open;
    for (uint32_t i = 0; i < mesh.triangles.size(); ++i) (parts.isOpen[i] ? open : closed).push_back(i);
    cells.addClosed(closed, parts.isTurnedAlike);
    cells.addOpen(open);
    ColorCounts colors;
    Level level;
    level.name = printableName(name);
    LevelBody& body = level.bodies.emplace_back();
    body.name = level.name;
    LevelShape& shape = body.shapes.emplace_back(cells.shape(colors));
    shape.name = level.name;
    const auto voxels = shape.grid.voxelCount();
    const std::string loss = mesh.lossNote(0.5 * settings.voxelSize / cells.scale());
    if (voxels == 0)
        return Error{"expected a part that is thicker than a voxel, found none: " +
                     (loss.empty() ? "more voxels may hold it" : loss)};
    if (!loss.empty()) notes.push_back(loss);
    notes.push_back(fmt::format("{} in {}, {}, {} -> {} of {:g} m in {} x {} x {} cells",
                                counted(mesh.triangles.size(), "triangle"), counted(parts.count, "part"),
                                counted(mesh.materials.size(), "material"), counted(mesh.textures.size(), "texture"),
                                counted(voxels, "voxel"), settings.voxelSize, cells.size().x, cells.size().y,
                                cells.size().z));
    notes.push_back(fmt::format("{} -> {} of the palette, at most {}/255 apart", counted(colors.found, "colour"),
                                counted(colors.entries, "entry", "entries"), colors.error));
    if (parts.open > 0)
        notes.push_back(
            fmt::format("{} of {} parts leak ({}): they have no inside, so only their surface became voxels",
                        parts.open, parts.count, counted(parts.openEdges, "open edge")));
    else if (settings.shell == 0)
        notes.push_back(volumeNote(volumeOf(mesh, parts.isOpen) * std::pow(cells.scale(), 3.0),
                                   double(voxels) * std::pow(settings.voxelSize, 3.0)));
    return level;
}

}  // namespace rubble
