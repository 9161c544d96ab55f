#include "runtime/destruction/free_body_fracture.h"

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "runtime/core/random.h"

// Fracture of a free body by an impact: d'Alembert's principle and beam theory.
//
// An impact F at a point p accelerates a rigid body of mass m and inertia I about its centre c by
//     a = F / m,   alpha = I^-1 ((p - c) x F),
// so a point x moves with a + alpha x (x - c). A part of mass m', centre c' and inertia I' above a cross-section is
// accelerated by the part below it, and acts back on it with
//     force  = -m' a(c')   (+ F if the impact is on the part above),
//     moment = (c' - s) x (-m' a(c')) - I' alpha   (+ (p - s) x F), about the section's centroid s.
// Beam theory turns both into stresses (cross_section.h). Each plane is computed exactly from sums over the layers of
// the body, so no system of equations is solved. The bending moment of a beam grows with the square of its length; to
// get parts that withstand the impact, the body breaks into about the square root of the utilization. Weights are
// densities; times the volume of a voxel they are masses, so forces are divided by that volume.

namespace rubble {
namespace {

constexpr int kMinBeamCells = 12;   ///< along shorter axes a body is no beam
constexpr int kMaxParts = 6;        ///< that one impact breaks a body into
constexpr double kMinAspect = 0.8;  ///< length of a part over its width where it broke: shorter ones are left whole

/// Moments of mass about the grid's corner, in cells. Exact below 2^53.
struct MassSum {
    double weight = 0.0;
    glm::dvec3 first{0.0};
    glm::dvec3 square{0.0}, mixed{0.0};  ///< second moments: xx yy zz and yz zx xy

    void add(double density, glm::dvec3 at) {
        weight += density;
        first += density * at;
        square += density * at * at;
        mixed += density * glm::dvec3(at.y * at.z, at.z * at.x, at.x * at.y);
    }
    MassSum& operator+=(const MassSum& other) {
        weight += other.weight, first += other.first, square += other.square, mixed += other.mixed;
        return *this;
    }
    glm::dvec3 center() const { return first / weight; }
    /// Inertia tensor about the centre.
    glm::dmat3 inertia() const {
        const glm::dvec3 c = center();
        const glm::dvec3 s = square - weight * c * c;
        const glm::dvec3 m = mixed - weight * glm::dvec3(c.y * c.z, c.z * c.x, c.x * c.y);
        const glm::dvec3 own =
            glm::dvec3(s.y + s.z, s.x + s.z, s.x + s.y) + weight / 6.0;  // each voxel is a cube of its weight
        return {own.x, -m.z, -m.y, -m.z, own.y, -m.x, -m.y, -m.x, own.z};
    }
};

/// Least length of a part whose cross-section has this width. Nearer to its end a body is no beam.
int shortestPart(double width) {
    return std::max(kMinBeamCells / 2, int(kMinAspect * width));
}

/// Square root of the area of the bounding rectangle of sections in one plane.
double widthOf(const std::vector<Section>& sections) {
    glm::ivec3 low(INT_MAX), high(INT_MIN);
    for (const Section& section : sections)
        for (uint64_t left = section.cells; left; left &= left - 1) {
            const glm::ivec3 cell = section.cellBelow(std::countr_zero(left));
            low = glm::min(low, cell), high = glm::max(high, cell + 1);
        }
    const glm::dvec3 size(high - low);  // one cell along the normal of the plane
    return std::sqrt(size.x * size.y * size.z);
}

/// The acceleration of the whole body by the impact.
struct Acceleration {
    glm::dvec3 center{0.0}, linear{0.0}, angular{0.0};
    glm::dvec3 at(glm::dvec3 point) const { return linear + glm::cross(angular, point - center); }
};

/// Lists the sections of a plane. size: of the grid in bricks; solidAt(brick): its load-bearing cells.
template <class F>
void findSections(glm::ivec3 size, int axis, int plane, F&& solidAt, std::vector<Section>& out) {
    out.clear();
    glm::ivec3 low(0), high = size, above(0);
    low[axis] = (plane - 1) / kBrickSize, high[axis] = low[axis] + 1;
    const int inBrick = plane - low[axis] * kBrickSize;
    above[axis] = inBrick == kBrickSize;
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) {
                const glm::ivec3 brick(x, y, z);
                const uint64_t below = brickLayer(solidAt(brick), axis, inBrick - 1);
                const bool hasAbove = brick[axis] + above[axis] < size[axis];
                const uint64_t cells =
                    below && hasAbove ? below & brickLayer(solidAt(brick + above), axis, cellInBrick(inBrick)) : 0;
                if (cells) out.push_back({brick, axis, inBrick, cells});
            }
}

/// A body and an impact on it.
class FreeBody {
public:
    FreeBody(const StressedShape& body, const ImpactForce& impact)
        : m_body(body),
          m_point(glm::dvec3(impact.cell) + 0.5),
          m_force(impact.force / (body.voxelSize * body.voxelSize * body.voxelSize)) {
        sumLayers();
    }

    /// All planes along an axis with their utilization. Too close to an end of the body it is zero.
    std::vector<FracturePlane> planes(int axis) {
        const int length = m_body.grid.size()[axis];
        std::vector<FracturePlane> out;
        if (!hasMass() || !bendsAlong(axis)) return out;
        out.reserve(size_t(length));
        MassSum above;
        for (int plane = length - 1; plane > 0; --plane) {
            above += m_layers[size_t(axis)][size_t(plane)];
            if (above.weight <= 0.0 || above.weight >= m_all.weight) continue;
            out.push_back(evaluatePlane(axis, plane, above));
        }
        std::reverse(out.begin(), out.end());
        for (FracturePlane& each : out)
            if (std::min(each.plane + 1 - out.front().plane, out.back().plane + 1 - each.plane) <
                shortestPart(each.width))
                each.utilization = 0.0;
        return out;
    }

private:
    bool hasMass() const { return m_all.weight > 0.0; }
    /// Whether the body is a beam along an axis.
    bool bendsAlong(int axis) const {
        const glm::ivec3 size = m_body.grid.size();
        return size[axis] >= kMinBeamCells && 2 * size[axis] >= std::max({size.x, size.y, size.z});
    }
    size_t brickIndex(glm::ivec3 brick) const {
        const glm::ivec3 size = m_body.grid.sizeInBricks();
        return (size_t(brick.z) * size_t(size.y) + size_t(brick.y)) * size_t(size.x) + size_t(brick.x);
    }

    void sumLayers() {
        for (int axis = 0; axis < 3; ++axis)
            if (bendsAlong(axis)) m_layers[size_t(axis)].resize(size_t(m_body.grid.size()[axis]));
        const glm::ivec3 size = m_body.grid.sizeInBricks();
        m_solidIndex.resize(size_t(size.x) * size_t(size.y) * size_t(size.z));
        m_solid.emplace_back();
        m_body.grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            m_solidIndex[brickIndex(position)] = uint32_t(m_solid.size());
            m_solid.push_back(solidCells(*brick, m_body.entries));
            forEachVoxel(brick->occupancy, [&](int i) {
                const glm::ivec3 cell = position * kBrickSize + voxelInBrick(i);
                MassSum voxel;
                voxel.add(m_body.entries[brick->at(i)].density, glm::dvec3(cell) + 0.5);
                for (int axis = 0; axis < 3; ++axis)
                    if (!m_layers[size_t(axis)].empty()) m_layers[size_t(axis)][size_t(cell[axis])] += voxel;
                m_all += voxel;
            });
        });
        if (!hasMass()) return;
        m_acceleration.center = m_all.center();
        m_acceleration.linear = m_force / m_all.weight;
        m_acceleration.angular = glm::inverse(m_all.inertia()) * glm::cross(m_point - m_acceleration.center, m_force);
    }

    /// The load and the utilization of a plane. above: the sum of the layers above it.
    FracturePlane evaluatePlane(int axis, int plane, const MassSum& above) {
        FracturePlane out{axis, plane};
        findSections(
            m_body.grid.sizeInBricks(), axis, plane,
            [&](glm::ivec3 brick) { return m_solid[m_solidIndex[brickIndex(brick)]]; }, m_sections);
        if (m_sections.empty()) return out;
        const int u = kSectionU[size_t(axis)], v = kSectionV[size_t(axis)];
        const glm::ivec3 origin = m_sections.front().brick;
        m_tiles.clear();
        for (const Section& each : m_sections)
            m_tiles.push_back({each.cells, each.brick[u] - origin[u], each.brick[v] - origin[v]});
        const SectionShape shape = sectionShape(m_sections.front(), m_tiles);
        out.width = widthOf(m_sections);
        const glm::dvec3 center = above.center();
        SectionForce load{-above.weight * m_acceleration.at(center), glm::dvec3(0.0)};
        load.moment = glm::cross(center - shape.centroid, load.force) - above.inertia() * m_acceleration.angular;
        if (m_point[axis] > plane) {
            load.force += m_force;
            load.moment += glm::cross(m_point - shape.centroid, m_force);
        }
        bool canAnyBreak = false;
        for (const Section& section : m_sections) {
            bool canBreak = false;
            SectionStrength strength = sectionStrength(m_body.grid, m_body.entries, section, canBreak);
            canAnyBreak = canAnyBreak || canBreak;
            const double scale = m_body.strengthScale / m_body.voxelSize;
            strength = {strength.tensile * scale, strength.compressive * scale, strength.shear * scale};
            const SectionUtilization found = sectionUtilization(section, shape, load, strength);
            if (found.utilization > out.utilization) out.utilization = found.utilization, out.cause = found.cause;
        }
        if (!canAnyBreak) out.utilization = 0.0;
        return out;
    }

    const StressedShape& m_body;
    glm::dvec3 m_point, m_force;
    std::array<std::vector<MassSum>, 3> m_layers;  ///< by axis and layer; empty where the body is no beam
    std::vector<uint32_t> m_solidIndex;            ///< by brickIndex(): where in m_solid its cells are
    std::vector<BrickBits> m_solid;                ///< load-bearing cells of each brick; the first: none
    MassSum m_all;
    Acceleration m_acceleration;
    std::vector<Section> m_sections;  ///< of a plane
    std::vector<SectionTile> m_tiles;
};

/// The planes at which the body breaks beside the worst one: spread along the body, `seed` moves them.
std::vector<FracturePlane> spreadPlanes(const std::vector<FracturePlane>& planes, const FracturePlane& worst,
                                        uint32_t seed) {
    const int first = planes.front().plane, length = planes.back().plane + 1 - first;
    const int shortest = shortestPart(worst.width);
    const int wanted = int(std::sqrt(std::min(worst.utilization, double(kMaxParts * kMaxParts)))) + 1;
    const int parts = std::clamp(std::min(wanted, length / shortest), 2, kMaxParts);
    std::vector<FracturePlane> out{worst};
    for (int i = 1; i < parts && int(out.size()) + 1 < parts; ++i) {
        const int range = length / parts / 3;
        const int jitter = int(hashCell(i, worst.plane, length, seed) % uint32_t(2 * range + 1)) - range;
        const int at = first + length * i / parts + jitter;
        const auto plane =
            std::find_if(planes.begin(), planes.end(), [&](const FracturePlane& each) { return each.plane >= at; });
        if (plane == planes.end() || !(plane->utilization * parts > 1.0)) continue;
        const bool isApart = std::all_of(out.begin(), out.end(), [&](const FracturePlane& each) {
            return std::abs(each.plane - plane->plane) >= std::max(shortest, length / parts / 2);
        });
        if (isApart) out.push_back(*plane);
    }
    return out;
}

}  // namespace

std::vector<Section> sectionsInPlane(const VoxelGrid& grid, const StrengthTable& entries, int axis, int plane) {
    std::vector<Section> out;
    const auto solidAt = [&](glm::ivec3 at) {
        const Brick* brick = grid.brickAt(at);
        return brick ? solidCells(*brick, entries) : BrickBits{};
    };
    findSections(grid.sizeInBricks(), axis, plane, solidAt, out);
    return out;
}

std::vector<FracturePlane> findFracturePlanes(const StressedShape& body, const ImpactForce& impact, uint32_t seed) {
    const auto isLess = [](const FracturePlane& a, const FracturePlane& b) { return a.utilization < b.utilization; };
    FreeBody freeBody(body, impact);
    std::vector<FracturePlane> planes;
    FracturePlane worst{0, 0, 1.0};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<FracturePlane> each = freeBody.planes(axis);
        const auto largest = std::max_element(each.begin(), each.end(), isLess);
        if (largest == each.end() || !(largest->utilization > worst.utilization)) continue;
        worst = *largest;
        planes = std::move(each);
    }
    if (planes.empty()) return {};
    std::vector<FracturePlane> out = spreadPlanes(planes, worst, seed);
    std::sort(out.begin(), out.end(), [](const FracturePlane& a, const FracturePlane& b) { return a.plane < b.plane; });
    return out;
}

}  // namespace rubble
