#include "physics/collision/time_of_impact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/collision/feature_query.h"
#include "physics/collision/hull_separation.h"
#include "physics/shapes/cell_transform.h"
#include "runtime/core/rotated_box.h"

// Time of impact of two voxel shapes.
//
// As in the search for contacts (voxel_contacts.cpp), two solids made of cubes meet first with the convex corners and
// edges of one or the other. Here each of these, a little inside its own solid, is followed along its path through the
// cells of the other. The paths are arcs, so the step is cut into intervals in which they are almost straight.

namespace rubble {
namespace {

constexpr float kPathInset = 0.15f;    ///< own cells by which a feature is inside its solid: what contacts may overlap
constexpr double kMaxSagitta = 0.1;    ///< voxels between an arc and its chord
constexpr double kMinInterval = 16.0;  ///< voxels of an interval, so that the box around it is not all of the level
constexpr int kMaxIntervals = 64;
constexpr double kLongestPath = 1e4;    ///< metres of a segment: no valid speed reaches as far
constexpr float kPathRounding = 1e-3f;  ///< cells
/// Voxels by which hulls may overlap before a feature can be inside by kPathInset.
constexpr float kMaxOverlap = 0.1f;
constexpr int kAxisIterations = 4;  ///< of the search for a separating axis

glm::vec3 direction(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 1e-6 ? glm::vec3(v / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

CellTransform cellsOf(const ColliderPart& part, const Pose& pose) {
    CellTransform cells = part.cellsAt(pose.rotation);
    cells.corner += pose.position;
    return cells;
}

/// The cells of one part in those of another.
struct RelativeCells {
    glm::mat3 axes;
    glm::vec3 corner;
    RelativeCells(const ColliderPart& from, const Pose& fromPose, const ColliderPart& into, const Pose& intoPose) {
        const CellTransform own = cellsOf(from, fromPose), other = cellsOf(into, intoPose);
        const glm::dmat3 back = metresToCells(other, into.voxelSize());
        axes = glm::mat3(back * own.axes);
        corner = glm::vec3(back * (own.corner - other.corner));
    }
    glm::vec3 operator()(const glm::vec3& cell) const { return corner + axes * cell; }
};

/// How far a point of one part is in front of the other's hull at an end of an interval: dot(normal, cell) - offset, in
/// cells of the other.
struct HullPlane {
    glm::vec3 normal;  ///< for cells of the one
    float offset;
    /// toFrom: a unit vector, world axes, from `into` to `from`.
    HullPlane(const ColliderPart& into, const Pose& intoPose, const RelativeCells& cells, const glm::vec3& toFrom) {
        const glm::dmat3 back = metresToCells(cellsOf(into, intoPose), into.voxelSize());
        const glm::vec3 direction = glm::vec3(back * glm::dvec3(toFrom)) * float(into.voxelSize());
        normal = direction * cells.axes;
        offset = into.hull().support(direction) - glm::dot(direction, cells.corner);
    }
    float distance(const glm::vec3& cell) const { return glm::dot(normal, cell) - offset; }
    /// The least distance of a box, from its middle and half size.
    float nearest(const glm::vec3& middle, const glm::vec3& half) const {
        return glm::dot(normal, middle) - glm::dot(glm::abs(normal), half) - offset;
    }
};

/// The features of one part on their way through another in an interval.
class FeatureSweep {
public:
    FeatureSweep(const ColliderPart& from, const ColliderPart& into, const RelativeCells& begin,
                 const RelativeCells& end, const HullPlane& beginPlane, const HullPlane& endPlane)
        : m_from(from),
          m_into(into),
          m_occupancy(into),
          m_begin(begin),
          m_end(end),
          m_beginPlane(beginPlane),
          m_endPlane(endPlane) {}

    /// The fraction of the interval at which the first feature enters; above 1: none.
    float firstEntry() {
        if (!mayMeetBrick()) return 2.0f;
        const CellBox near = nearCells();
        if (glm::any(glm::greaterThanEqual(near.low, near.high))) return 2.0f;
        if (const PartSurface* surface = m_from.whole()) {
            sweepFeatures(surface->features(), surface->rows.box().low, near);
            return m_first;
        }
        const Cell low = brickOfCell(near.low), high = brickOfCell(near.high - 1);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x)
                    if (m_from.grid().brickAt({x, y, z}))
                        sweepFeatures(m_from.features({x, y, z}), Cell(x, y, z) * kBrickSize, near);
        return m_first;
    }

private:
    /// The cells of `from` that may come near a solid cell of `into`: those that its bounds sweep, seen from `from`.
    CellBox nearCells() const {
        const CellBox& other = m_into.bounds();
        const glm::vec3 middle = glm::vec3(other.low + other.high) * 0.5f,
                        half = glm::vec3(other.high - other.low) * 0.5f;
        glm::vec3 low(1e30f), high(-1e30f);
        for (const RelativeCells* cells : {&m_begin, &m_end}) {
            const glm::mat3 back = glm::inverse(cells->axes);
            const glm::vec3 center = back * (middle - cells->corner), extent = rotatedHalfExtent(back, half);
            low = glm::min(low, center - extent), high = glm::max(high, center + extent);
        }
        const CellBox& own = m_from.bounds();
        const glm::vec3 rotation(1.0f);  // cells by which a point leaves the box of the two ends within the interval
        low = glm::clamp(low - rotation, glm::vec3(own.low), glm::vec3(own.high));
        high = glm::clamp(high + rotation, glm::vec3(own.low), glm::vec3(own.high));
        return {Cell(glm::floor(low)), Cell(glm::ceil(high))};
    }
    /// corner: of the region that the features belong to.
    void sweepFeatures(const FeatureList& features, Cell corner, const CellBox& near) {
        const glm::vec3 low(near.low - corner), high(near.high - corner);
        for (const FeatureList::ClusterPack& clusters : features.clusters)
            for (size_t k = 0; k < 4; ++k) {
                glm::vec3 from, to;
                for (int axis = 0; axis < 3; ++axis) {
                    from[axis] = 0.5f * float(clusters.low[size_t(axis)][k]);
                    to[axis] = 0.5f * float(clusters.high[size_t(axis)][k]);
                }
                if (glm::any(glm::greaterThan(from, to)) || glm::any(glm::lessThan(to, low)) ||
                    glm::any(glm::greaterThan(from, high)) ||
                    !mayMeet(from + glm::vec3(corner), to + glm::vec3(corner)))
                    continue;
                for (uint32_t i = clusters.from[k]; i < clusters.to[k]; ++i) sweepPack(features.packs[i], corner);
            }
    }
    void sweepPack(const FeatureList::Pack& pack, Cell corner) {
        for (size_t k = 0; k < 4; ++k) {
            if (pack.kind[k] >= kFeatureKinds) continue;
            const glm::vec3 at = glm::vec3(pack.x[k], pack.y[k], pack.z[k]) * 0.5f + glm::vec3(corner);
            sweepPoint(at - featureKinds()[pack.kind[k]].outward * kPathInset);
        }
    }
    /// The cells of `into` that a box of cells of `from` sweeps.
    std::pair<Int4, Int4> sweptCells(const glm::vec3& middle, const glm::vec3& half) const {
        glm::vec3 from(1e30f), to(-1e30f);
        for (const RelativeCells* cells : {&m_begin, &m_end}) {
            const glm::vec3 center = (*cells)(middle), extent = rotatedHalfExtent(cells->axes, half);
            from = glm::min(from, center - extent), to = glm::max(to, center + extent);
        }
        return {floorOf(float4(from - kPathRounding)), floorOf(float4(to + kPathRounding))};
    }
    /// Conservative: whether `from` may meet a brick of `into` in the interval.
    bool mayMeetBrick() const {
        const glm::vec3 low(m_from.bounds().low), high(m_from.bounds().high);
        const auto [from, to] = sweptCells((low + high) * 0.5f, (high - low) * 0.5f);
        return m_occupancy.mayContainBrick(from, to);
    }
    /// Conservative: whether a point in a box of cells of `from` may meet a solid cell in the interval.
    bool mayMeet(const glm::vec3& low, const glm::vec3& high) {
        const glm::vec3 middle = (low + high) * 0.5f, half = (high - low) * 0.5f;
        const glm::vec3 around = half + kPathInset;
        if (m_beginPlane.nearest(middle, around) > 0.0f && m_endPlane.nearest(middle, around) > 0.0f) return false;
        const auto [from, to] = sweptCells(middle, half);
        return m_occupancy.mayContainSolid(from, to);
    }
    void sweepPoint(const glm::vec3& own) {
        if (m_beginPlane.distance(own) > 0.0f && m_endPlane.distance(own) > 0.0f) return;
        const glm::vec3 begin = m_begin(own), end = m_end(own);
        const glm::vec3 low = glm::min(begin, end) - kPathRounding, high = glm::max(begin, end) + kPathRounding;
        if (!m_occupancy.mayContainSolid(floorOf(float4(low)), floorOf(float4(high)))) return;
        if (m_occupancy.solid(cellOf(begin))) return;
        m_first = std::min(m_first, timeOfEntry(m_occupancy, begin, end - begin));
    }

    const ColliderPart& m_from;
    const ColliderPart& m_into;
    Occupancy m_occupancy;  ///< of `into`
    const RelativeCells& m_begin;
    const RelativeCells& m_end;
    const HullPlane& m_beginPlane;
    const HullPlane& m_endPlane;
    float m_first = 2.0f;
};

/// The poses of the two colliders at the ends of an interval.
struct Interval {
    std::array<Pose, 2> first, second;
    /// Into how many parts of almost straight paths it is to be cut. straight: radians by which each may turn.
    double arcs(const std::array<double, 2>& straight) const {
        return std::max(largestAngle(first[0].rotation, first[1].rotation) / straight[0],
                        largestAngle(second[0].rotation, second[1].rotation) / straight[1]);
    }
    /// The least distance of the colliders' origins, metres.
    double nearest() const {
        const glm::dvec3 from = first[0].position - second[0].position,
                         way = first[1].position - second[1].position - from;
        const double length2 = glm::dot(way, way);
        const double share = length2 > 0.0 ? std::clamp(-glm::dot(from, way) / length2, 0.0, 1.0) : 0.0;
        return glm::length(from + way * share);
    }
    /// How far the colliders' origins move relative to each other, metres.
    double length() const {
        return glm::length((first[1].position - second[1].position) - (first[0].position - second[0].position));
    }
};

TransformedHull hullOf(const ColliderPart& part, const Pose& pose, const glm::dvec3& origin) {
    const CellTransform cells = cellsOf(part, pose);
    return {part.hull(), glm::mat3(cells.axes), glm::vec3(cells.corner - origin)};
}

/// Whether one plane separates the hulls of two parts at the ends of all segments of the paths, but for what contacts
/// may overlap. axis: a unit vector to start from, replaced by a better one.
bool areSeparated(const ColliderPart& a, const SweptPose& pathA, const ColliderPart& b, const SweptPose& pathB,
                  size_t segments, glm::vec3& axis) {
    const glm::dvec3 origin = pathA.poses.back().position;
    const float tolerance = kMaxOverlap * float(std::min(a.voxelSize(), b.voxelSize()));
    for (size_t i = segments + 1; i-- > 0;) {
        const double fraction = double(i) / double(segments);
        const TransformedHull hullA = hullOf(a, pathA.at(fraction), origin),
                              hullB = hullOf(b, pathB.at(fraction), origin);
        const HullGap gap = i == segments ? refineSeparatingAxis(hullA, hullB, tolerance, kAxisIterations, axis)
                                          : HullGap(hullA, hullB, axis);
        if (!(gap.distance() > -tolerance)) return false;
    }
    return true;
}

/// The fraction of an interval at which one collider enters the other; above 1: it does not.
float firstEntry(const VoxelCollider& first, const VoxelCollider& second, const Interval& interval) {
    float earliest = 2.0f;
    for (const auto& a : first.parts)
        for (const auto& b : second.parts) {
            if (a->grid().empty() || b->grid().empty() || !a->filter().meets(b->filter())) continue;
            glm::vec3 axis = direction(interval.first[1].position - interval.second[1].position);
            if (areSeparated(*a, {interval.first}, *b, {interval.second}, 1, axis)) continue;
            const RelativeCells begin(*a, interval.first[0], *b, interval.second[0]),
                end(*a, interval.first[1], *b, interval.second[1]),
                backBegin(*b, interval.second[0], *a, interval.first[0]),
                backEnd(*b, interval.second[1], *a, interval.first[1]);
            const HullPlane beginPlane(*b, interval.second[0], begin, axis),
                endPlane(*b, interval.second[1], end, axis), backBeginPlane(*a, interval.first[0], backBegin, -axis),
                backEndPlane(*a, interval.first[1], backEnd, -axis);
            earliest = std::min({earliest, FeatureSweep(*a, *b, begin, end, beginPlane, endPlane).firstEntry(),
                                 FeatureSweep(*b, *a, backBegin, backEnd, backBeginPlane, backEndPlane).firstEntry()});
        }
    return earliest;
}

}  // namespace

double largestAngle(const glm::dquat& from, const glm::dquat& to) {
    const glm::dquat chord = to - from * (glm::dot(from, to) < 0.0 ? -1.0 : 1.0);
    return 2.24 * std::sqrt(glm::dot(chord, chord));  // 2 sin(angle / 4), to half a turn
}

Pose SweptPose::at(double fraction) const {
    const double place = fraction * double(poses.size() - 1);
    const size_t i = std::min(size_t(place), poses.size() - 2);
    const double share = place - double(i);
    const Pose &from = poses[i], &to = poses[i + 1];
    const glm::dquat end = glm::dot(from.rotation, to.rotation) < 0.0 ? -to.rotation : to.rotation;
    return {from.position + (to.position - from.position) * share,
            glm::normalize(from.rotation * (1.0 - share) + end * share)};
}

double timeOfImpact(const VoxelCollider& first, const SweptPose& firstPath, const VoxelCollider& second,
                    const SweptPose& secondPath, const glm::vec3& axis) {
    const double firstRadius = first.radius(), secondRadius = second.radius(), reach = firstRadius + secondRadius,
                 voxel = std::min(first.smallestVoxel(), second.smallestVoxel()),
                 shortest = std::max(2.0 * std::min(firstRadius, secondRadius), kMinInterval * voxel);
    // What a body touches is within its radius of what it turns about.
    const auto straightAngle = [&](double radius) {
        return std::sqrt(8.0 * kMaxSagitta * voxel / std::max(radius, voxel));
    };
    const std::array<double, 2> straight{straightAngle(firstRadius), straightAngle(secondRadius)};
    const size_t segments = std::max(firstPath.poses.size(), secondPath.poses.size()) - 1;
    const auto intervalOf = [&](double from, double to) {
        return Interval{{firstPath.at(from), firstPath.at(to)}, {secondPath.at(from), secondPath.at(to)}};
    };
    if (!(intervalOf(0.0, 1.0).length() < kLongestPath)) return 2.0;
    if (first.parts.size() == 1 && second.parts.size() == 1) {
        double arcs = 0.0;
        for (size_t i = 0; i < segments; ++i)
            arcs = std::max(arcs,
                            intervalOf(double(i) / double(segments), double(i + 1) / double(segments)).arcs(straight));
        glm::vec3 toFirst = axis;
        if (axis == glm::vec3(0.0f))
            toFirst = direction(firstPath.poses.back().position - secondPath.poses.back().position);
        if (arcs <= 1.0 && areSeparated(*first.parts[0], firstPath, *second.parts[0], secondPath, segments, toFirst))
            return 2.0;
    }
    for (size_t segment = 0; segment < segments; ++segment) {
        const double begin = double(segment) / double(segments), length = 1.0 / double(segments);
        const Interval whole = intervalOf(begin, begin + length);
        if (whole.nearest() > reach) continue;
        const double parts = std::max(whole.arcs(straight), whole.length() / shortest);
        const int intervals = int(std::clamp(std::ceil(parts), 1.0, double(kMaxIntervals)));
        for (int i = 0; i < intervals; ++i) {
            const double from = begin + length * i / intervals, to = begin + length * (i + 1) / intervals;
            const Interval interval = intervalOf(from, to);
            if (interval.nearest() > reach) continue;
            const float entry = firstEntry(first, second, interval);
            if (entry <= 1.0f) return from + double(entry) * (to - from);
        }
    }
    return 2.0;
}

}  // namespace rubble
