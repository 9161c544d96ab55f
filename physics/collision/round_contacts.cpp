#include "physics/collision/round_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/collision/feature_query.h"
#include "physics/collision/occupancy.h"

// Contacts of spheres and cylinders with voxels.
//
// As in the search between voxels (voxel_contacts.cpp), each side's outermost points are held against the other:
//   1. The points of the round surface that lie the farthest in each of the six directions of the voxels' axes, two
//      for a cylinder, against the faces of the voxels.
//   2. The convex corners and edges of the voxels against the round surface, by their distance from its axis.
// A sphere against what is round is its middle against a surface that is wider by its radius. What spins about its own
// axis keeps its surface, so that the way of a point leaves that spin out; in the solver too (contact_math.h).

namespace rubble {
namespace {

constexpr float kMaxDepth = 1.5f;    ///< cells below a face from which a point is pushed out through it
constexpr float kFlatCosine = 0.7f;  ///< between a face's normal and an axis above which a cylinder lies on its end
constexpr float kTiny = 1e-6f;
constexpr uint64_t kRoundKind = 21;  ///< in place of a feature's kind

/// A round part in the cells of another.
struct RoundInCells {
    glm::vec3 center, axis;  ///< axis: a unit vector; 0: a sphere
    float radius, halfLength;

    RoundInCells(const RoundSurface& round, const glm::mat3& axes, const glm::vec3& corner, float scale)
        : center(corner + axes * round.center),
          axis(axes * round.direction() / scale),
          radius(round.radius * scale),
          halfLength(round.halfLength * scale) {}
    bool isSphere() const { return axis == glm::vec3(0.0f); }
    /// The half size of the box around it.
    glm::vec3 extent() const {
        if (isSphere()) return glm::vec3(radius);
        const glm::vec3 across = glm::sqrt(glm::max(glm::vec3(1.0f) - axis * axis, 0.0f));
        return glm::abs(axis) * halfLength + across * radius;
    }
    /// The farthest that it reaches from its middle along a unit vector.
    float reach(const glm::vec3& direction) const {
        const float along = glm::dot(direction, axis);
        return halfLength * std::abs(along) + radius * std::sqrt(std::max(1.0f - along * along, 0.0f));
    }
    /// A unit vector across the axis.
    glm::vec3 besideAxis() const {
        const glm::vec3 side = std::abs(axis.y) > 0.7f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
        return glm::normalize(side - axis * glm::dot(side, axis));
    }
    /// The distance of a point from the surface, negative inside, and the unit vector away from the surface.
    float distance(const glm::vec3& point, glm::vec3& normal) const {
        const glm::vec3 from = point - center;
        const float along = glm::dot(from, axis);
        const glm::vec3 across = from - axis * along;
        const float length = std::sqrt(glm::dot(across, across)), side = length - radius,
                    end = std::abs(along) - halfLength;
        const glm::vec3 out = length > kTiny ? across / length : besideAxis(), cap = along < 0.0f ? -axis : axis;
        if (isSphere() || (end <= 0.0f && side >= end)) return normal = out, side;
        if (side <= 0.0f) return normal = cap, end;
        const float rim = std::sqrt(side * side + end * end);
        return normal = (out * side + cap * end) / rim, rim;
    }
    /// The fraction of a displacement at which a point that is outside of the surface enters it, and the normal there;
    /// above 1: it does not.
    float entry(const glm::vec3& point, const glm::vec3& displacement, glm::vec3& normal) const {
        const glm::vec3 from = point - center;
        const float along = glm::dot(from, axis), alongStep = glm::dot(displacement, axis);
        const glm::vec3 across = from - axis * along, step = displacement - axis * alongStep;
        float enter = -1e30f, leave = 1e30f;
        const float a = glm::dot(step, step), b = glm::dot(across, step),
                    c = glm::dot(across, across) - radius * radius;
        if (a > kTiny * kTiny) {
            const float root2 = b * b - a * c;
            if (root2 <= 0.0f) return 2.0f;
            const float root = std::sqrt(root2);
            enter = (-b - root) / a, leave = (-b + root) / a;
            normal = (across + step * enter) / radius;
        } else if (c > 0.0f) {
            return 2.0f;
        }
        if (!isSphere()) {
            if (std::abs(alongStep) < kTiny && std::abs(along) > halfLength) return 2.0f;
            const float sign = alongStep > 0.0f ? -1.0f : 1.0f;
            if (std::abs(alongStep) >= kTiny) {
                const float t = (sign * halfLength - along) / alongStep;
                leave = std::min(leave, (-sign * halfLength - along) / alongStep);
                if (t > enter) enter = t, normal = axis * sign;
            }
        }
        return enter >= 0.0f && enter <= leave ? enter : 2.0f;
    }
};

/// Finds the contacts of a round part with another, in whose cells it computes.
class RoundCollider {
public:
    RoundCollider(const MovingPart& round, const MovingPart& other, bool isFirst, const NarrowphaseSettings& settings,
                  uint64_t key, std::vector<ContactPoint>& out)
        : m_round(round),
          m_other(other),
          m_isFirst(isFirst),
          m_key(key | (isFirst ? kFirstIsRound : kSecondIsRound)),
          m_settings(settings),
          m_out(out),
          m_size(float(other.part.voxelSize())),
          m_toCells(metresToCells(other.cells, other.part.voxelSize())),
          m_margin(float(settings.margin) / m_size),
          m_surface(*round.part.round(), glm::mat3(m_toCells * round.cells.axes),
                    glm::vec3(m_toCells * (round.cells.corner - other.cells.corner)),
                    float(round.part.voxelSize() / other.part.voxelSize())) {
        const glm::dvec3 axis = glm::dvec3(toWorld(m_surface.axis));
        m_ownSpin = m_surface.isSphere() ? round.spin : axis * glm::dot(axis, round.spin);
        m_center = other.cells.corner + other.cells.axes * glm::dvec3(m_surface.center);
    }

    /// The round surface against the faces of the other's voxels.
    void collideFaces() {
        Occupancy occupancy(m_other.part, m_other.cover);
        for (int direction = 0; direction < 6; ++direction) {
            glm::vec3 normal(0.0f);
            normal[direction / 2] = direction % 2 ? 1.0f : -1.0f;
            std::array<glm::vec3, 8> points;
            const int count = lowestPoints(normal, points);
            for (int i = 0; i < count; ++i) {
                float separation;
                Cell cell;
                if (!findFace(occupancy, points[size_t(i)], direction, separation, cell)) continue;
                const glm::vec3 middle = points[size_t(i)] - normal * (0.5f * separation);
                add(middle, m_isFirst ? normal : -normal, separation, m_other.part.grid().at(cell),
                    uint64_t(direction * 8 + i) << 17 | (m_isFirst ? 0 : 1));
            }
        }
    }
    /// The corners and edges of the other's voxels against the round surface.
    void collideFeatures() {
        if (const PartSurface* surface = m_other.part.whole())
            return collideList(surface->features(), surface->rows.box().low);
        const glm::vec3 reach = m_surface.extent() + m_margin + glm::abs(displacementAt(m_surface.center)) + 1.0f;
        const CellBox& own = m_other.part.bounds();
        const Cell low = brickOfCell(glm::max(cellOf(m_surface.center - reach), own.low)),
                   high = brickOfCell(glm::min(cellOf(m_surface.center + reach), own.high - 1));
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x)
                    if (const Cell brick(x, y, z); m_other.part.grid().brickAt(brick))
                        collideList(m_other.part.features(brick), brick * kBrickSize);
    }
    /// A sphere against the round surface.
    void collideSphere(const RoundSurface& sphere) {
        const glm::vec3 middle = sphere.center;
        RoundInCells wide = m_surface;
        wide.radius += sphere.radius, wide.halfLength += sphere.radius;
        glm::vec3 normal;
        float separation = m_surface.distance(middle, normal) - sphere.radius;
        if (separation > m_margin && !sweep(wide, middle, normal, separation)) return;
        const glm::vec3 at = middle - normal * (sphere.radius + 0.5f * separation);
        m_key |= kFirstIsRound | kSecondIsRound;
        add(at, m_isFirst ? -normal : normal, separation, sphere.entry, 0);
    }

private:
    glm::vec3 toWorld(const glm::vec3& direction) const {
        return glm::vec3(m_other.cells.axes * glm::dvec3(direction)) / m_size;
    }
    /// How a point of the round surface moves in the step, cells; without the spin about its axis.
    glm::vec3 displacementAt(const glm::vec3& point) const {
        const glm::dvec3 at = m_other.cells.corner + m_other.cells.axes * glm::dvec3(point);
        const glm::dvec3 velocity =
            m_round.velocityAt(at) - glm::cross(m_ownSpin, at - m_center) - m_other.velocityAt(at);
        return glm::vec3(m_toCells * velocity) * float(m_settings.seconds);
    }
    /// The points that lie the farthest against a normal; returns how many.
    int lowestPoints(const glm::vec3& normal, std::array<glm::vec3, 8>& points) const {
        if (m_surface.isSphere()) return points[0] = m_surface.center - normal * m_surface.radius, 1;
        const float cosine = glm::dot(normal, m_surface.axis);
        glm::vec3 across = normal - m_surface.axis * cosine;
        const float length = std::sqrt(glm::dot(across, across));
        if (length > 1e-3f) {
            across /= length;
        } else {
            const glm::vec3 side = std::abs(normal.x) > 0.5f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
            across = side - m_surface.axis * glm::dot(side, m_surface.axis);
            across /= std::sqrt(glm::dot(across, across));
        }
        int count = 0;
        for (const float end : {-1.0f, 1.0f}) {
            const glm::vec3 base = m_surface.center + m_surface.axis * (end * m_surface.halfLength);
            const bool isFlat = end * cosine < -kFlatCosine;
            if (std::abs(cosine) > kFlatCosine && !isFlat) continue;
            points[size_t(count++)] = base - across * m_surface.radius;
            if (!isFlat) continue;
            const glm::vec3 side = glm::cross(m_surface.axis, across);
            for (const glm::vec3& d : {across, side, -side}) points[size_t(count++)] = base + d * m_surface.radius;
        }
        return count;
    }
    /// The face of a normal (see collideFaces()) that a point is in, near or about to meet.
    bool findFace(Occupancy& occupancy, const glm::vec3& point, int direction, float& separation, Cell& cell) const {
        const int axis = direction / 2, up = direction % 2 ? 1 : -1;
        const float sign = float(up);
        cell = cellOf(point);
        const auto distance = [&](Cell c) { return (point[axis] - float(up > 0 ? c[axis] + 1 : c[axis])) * sign; };
        if (occupancy.solid(cell)) {
            for (Cell next = cell;; cell = next) {
                next[axis] += up;
                separation = distance(cell);
                if (separation < -kMaxDepth) return false;
                if (!occupancy.solid(next)) return occupancy.exposed(cell, point, axis, up);
            }
        }
        cell[axis] -= up;
        separation = distance(cell);
        if (separation <= m_margin && occupancy.solid(cell)) return occupancy.exposed(cell, point, axis, up);
        FeatureQuery any{};
        any.kind = &featureKinds()[0];
        const Face face = sweepToFace(occupancy, cellOf(point), point, displacementAt(point), any);
        separation = face.separation, cell = face.cell;
        return face.axis == axis && face.sign == sign;
    }
    void collideList(const FeatureList& features, Cell corner) {
        const glm::vec3 way = displacementAt(m_surface.center), reach = m_surface.extent() + m_margin + 1.0f;
        const glm::vec3 low = (m_surface.center - reach + glm::min(way, 0.0f) - glm::vec3(corner)) * 2.0f,
                        high = (m_surface.center + reach + glm::max(way, 0.0f) - glm::vec3(corner)) * 2.0f;
        for (const FeatureList::ClusterPack& clusters : features.clusters)
            for (size_t k = 0; k < 4; ++k) {
                bool isNear = true;
                for (int axis = 0; axis < 3; ++axis)
                    isNear = isNear && clusters.low[size_t(axis)][k] <= clusters.high[size_t(axis)][k] &&
                             float(clusters.low[size_t(axis)][k]) <= high[axis] &&
                             float(clusters.high[size_t(axis)][k]) >= low[axis];
                if (!isNear) continue;
                for (uint32_t i = clusters.from[k]; i < clusters.to[k]; ++i)
                    for (size_t lane = 0; lane < 4; ++lane)
                        if (features.packs[i].kind[lane] < kFeatureKinds)
                            collideFeature(features.packs[i], lane, corner);
            }
    }
    void collideFeature(const FeatureList::Pack& pack, size_t lane, Cell corner) {
        const FeatureKind& kind = featureKinds()[pack.kind[lane]];
        glm::vec3 point = glm::vec3(pack.x[lane], pack.y[lane], pack.z[lane]) * 0.5f + glm::vec3(corner);
        if (kind.edgeAxis >= 0) point[kind.edgeAxis] += nearestOnEdge(point, kind.edgeAxis);
        glm::vec3 normal;
        float separation = m_surface.distance(point, normal);
        if (separation > m_margin && !sweep(m_surface, point, normal, separation)) return;
        if (separation < -kMaxDepth) return;
        for (int axis = 0; axis < 3; ++axis)
            if (normal[axis] * kind.outward[axis] > kMaxSideCosine) return;
        const Cell own = corner + FeatureList::cellOf(pack, lane);
        if (!straighten(own, kind, point, normal, separation)) return;
        add(point - normal * (0.5f * separation), m_isFirst ? -normal : normal, separation, m_other.part.grid().at(own),
            uint64_t(uint32_t(own.x)) << 41 | uint64_t(uint32_t(own.y)) << 29 | uint64_t(uint32_t(own.z)) << 17 |
                uint64_t(pack.kind[lane]) << 12 | (m_isFirst ? 1 : 0));
    }
    /// Along an edge, and where something lies against the other beside a feature, its surface goes straight on, and
    /// what rolls must not hit a seam: a normal may not lean that way. Of what touches the surface there already, only
    /// the feature right below counts. False: there is no contact.
    bool straighten(Cell own, const FeatureKind& kind, glm::vec3& point, glm::vec3& normal, float& separation) const {
        const glm::vec3 from = point - m_surface.center,
                        across = from - m_surface.axis * glm::dot(from, m_surface.axis);
        glm::vec3 straight = normal, below = point;
        bool isBelow = true, isCovered = false;
        for (int axis = 0; axis < 3; ++axis) {
            if (normal[axis] == 0.0f) continue;
            const int side = kind.outward[axis] > 0.0f ? 1 : -1;
            if (axis != kind.edgeAxis) {
                if (!m_other.cover || !m_other.cover->covers(own, point, axis, side)) continue;
                isCovered = true;
            }
            isBelow = isBelow && std::abs(across[axis]) <= kSeam && std::abs(normal[axis]) <= kMaxSideCosine;
            straight[axis] = 0.0f, below[axis] -= across[axis];
        }
        if (straight == normal) return true;
        const float length = std::sqrt(glm::dot(straight, straight));
        if (length < kTiny) return false;
        straight /= length;
        const float gap = glm::dot(from, straight) - m_surface.reach(straight);
        if (gap > m_margin) return !isCovered;  // it comes from farther away
        point = below, normal = straight, separation = gap;
        return isBelow;
    }
    /// Where an edge of a voxel is nearest to the axis, or to the middle of a sphere: -0.5 to 0.5 from its middle.
    float nearestOnEdge(const glm::vec3& middle, int edgeAxis) const {
        glm::vec3 edge(0.0f);
        edge[edgeAxis] = 1.0f;
        const glm::vec3 across = edge - m_surface.axis * m_surface.axis[edgeAxis], from = middle - m_surface.center;
        const float length2 = glm::dot(across, across);
        return length2 > kTiny ? std::clamp(-glm::dot(from, across) / length2, -0.5f, 0.5f) : 0.0f;
    }
    /// Follows a point of the other on its way to a surface; true if it meets it within the step.
    bool sweep(const RoundInCells& surface, const glm::vec3& point, glm::vec3& normal, float& separation) const {
        const glm::vec3 way = -displacementAt(point);
        const float share = glm::dot(way, way) > m_margin * m_margin ? surface.entry(point, way, normal) : 2.0f;
        if (share > 1.0f) return false;
        separation = -glm::dot(way, normal) * share;
        return true;
    }
    /// at: halfway between the surfaces. normal: from the second body to the first. Both in cells of the other.
    void add(const glm::vec3& at, const glm::vec3& normal, float separation, uint8_t otherEntry, uint64_t feature) {
        const ContactMaterials &own = m_round.part.contactMaterials(), &other = m_other.part.contactMaterials();
        const uint8_t entry = m_round.part.round()->entry;
        ContactPoint contact;
        contact.position = glm::vec3(m_other.cells.axes * glm::dvec3(at) + m_other.cells.corner);
        contact.normal = toWorld(normal);
        contact.separation = separation * m_size;
        contact.friction = std::sqrt(own.friction[entry] * other.friction[otherEntry]);
        contact.restitution = std::sqrt(own.restitution[entry] * other.restitution[otherEntry]);
        contact.feature = m_key | (feature >> 12 & 31 ? 0 : kRoundKind << 12) | feature;
        m_out.push_back(contact);
    }

    const MovingPart& m_round;
    const MovingPart& m_other;
    bool m_isFirst;  ///< the round part belongs to the first body
    uint64_t m_key;
    const NarrowphaseSettings& m_settings;
    std::vector<ContactPoint>& m_out;
    float m_size;  ///< of a cell of the other, metres
    glm::dmat3 m_toCells;
    float m_margin;  ///< cells
    RoundInCells m_surface;
    glm::dvec3 m_ownSpin, m_center;  ///< spin that does not move the surface; its middle; world axes
};

}  // namespace

void collideRound(const MovingPart& first, const MovingPart& second, const NarrowphaseSettings& settings,
                  uint64_t partKey, std::vector<ContactPoint>& out) {
    const RoundSurface *a = first.part.round(), *b = second.part.round();
    const auto isSphere = [](const RoundSurface* round) { return round && round->axis < 0; };
    RoundCollider ofFirst(a ? first : second, a ? second : first, a != nullptr, settings, partKey, out);
    if (!a || !b) {
        ofFirst.collideFaces();
        return ofFirst.collideFeatures();
    }
    if (isSphere(b)) return ofFirst.collideSphere(*b);
    RoundCollider ofSecond(second, first, false, settings, partKey, out);
    if (isSphere(a)) return ofSecond.collideSphere(*a);
    ofFirst.collideFeatures();
    ofSecond.collideFeatures();
}

}  // namespace rubble
