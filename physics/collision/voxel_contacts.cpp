#include "physics/collision/voxel_contacts.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "physics/collision/depenetration.h"
#include "physics/collision/hull_separation.h"
#include "physics/math/simd4.h"

namespace rubble {
namespace {

constexpr float kInset =
    0.05f;  ///< voxels that a feature is looked up inside of its own solid: edges that line up still meet
constexpr float kRounding = 1e-3f;  ///< cells by which more is looked at than should be needed
constexpr float kSearchDistance =
    0.15f;  ///< voxels, more than the margin, around a corner or edge in which contacts are looked for
constexpr int kNewPairIterations = 4,
              kKnownPairIterations = 1;  ///< in the search for a gap, of pairs that are new and not
constexpr float kMinStuckDepth =
    0.25f;  ///< cells that a feature without a displacement out must be in for it to count though others touch
constexpr float kMinAgreement =
    0.5f;  ///< length of the mean normal of contacts below which they push against each other
constexpr float kMinEdgeSine = 0.15f;  ///< sine centerAxis edges below which they do not cross

/// One shape's features against another's occupancy.
class FeatureCollider {
public:
    FeatureCollider(const VoxelPart& from, const CellTransform& fromCells, const VoxelPart& into,
                    const CellTransform& intoCells)
        : m_from(from), m_into(into), m_occupancy(into), m_intoCells(intoCells), m_margin(0) {
        const double size = into.voxelSize();
        const glm::dmat3 toInto = glm::transpose(intoCells.axes) / (size * size);
        m_axes = glm::mat3(toInto * fromCells.axes);
        m_corner = glm::vec3(toInto * (fromCells.corner - intoCells.corner));
        m_scale = float(from.voxelSize() / size);
        for (int i = 0; i < 3; ++i) m_unit[i] = m_axes[i] / m_scale;
    }

    /// velocity (at the first body's frame origin) and spin of `from` against `into`, world axes. displacement: the
    /// longest that a feature moves in the step, metres.
    void setMotion(glm::dvec3 velocity, glm::dvec3 spin, const NarrowphaseSettings& settings, double displacement) {
        const double size = m_into.voxelSize();
        m_margin = std::min(float(settings.margin / size), 0.4f);
        m_sweeps = displacement > settings.sweepThreshold;
        m_searchDistance = m_margin + (m_sweeps ? float(displacement / size) : 0.0f);
        if (!m_sweeps) return;
        const glm::dmat3 toInto = glm::transpose(m_intoCells.axes) / (size * size);
        m_velocity = glm::vec3(toInto * velocity) * float(settings.seconds);
        m_spin = glm::vec3(glm::transpose(m_intoCells.axes) * spin / size) * float(settings.seconds);
        m_about = glm::vec3(toInto * -m_intoCells.corner);
    }

    /// Features beyond `limit` along a direction, world axes and metres from the first body's frame origin, meet
    /// nothing.
    void setLimit(const glm::vec3& direction, float limit, const CellTransform& fromCells) {
        m_direction = direction * glm::mat3(fromCells.axes);
        m_limit = limit - glm::dot(direction, glm::vec3(fromCells.corner)) +
                  0.5f * std::max({std::abs(m_direction.x), std::abs(m_direction.y), std::abs(m_direction.z)});
    }

    /// False if nothing of the two is near.
    bool run(bool isFirst, uint64_t partKey, std::vector<ContactPoint>& out) {
        m_isFirst = isFirst;
        m_key = partKey;
        m_low = glm::vec3(m_into.bounds().low) - m_searchDistance;
        m_high = glm::vec3(m_into.bounds().high) + m_searchDistance;
        CellBox near;
        if (!overlap(near)) return false;
        setSearchExtents();
        if (m_sweeps) boundSweep();
        if (!boxMayTouchSolid(glm::vec3(near.low), glm::vec3(near.high))) return false;
        if (const PartSurface* surface = m_from.whole()) {
            collideFeatures(surface->features, surface->rows.box().low, near, out);
            return true;
        }
        const Cell low = near.low >> 3, high = (near.high - 1) >> 3;
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) {
                    const Cell brick(x, y, z), corner = brick * kBrickSize;
                    if (m_from.grid().brickAt(brick) &&
                        boxMayTouchSolid(glm::vec3(glm::max(near.low - 1, corner)),
                                         glm::vec3(glm::min(near.high + 1, corner + kBrickSize))))
                        collideFeatures(m_from.features(brick), corner, near, out);
                }
        return true;
    }

    /// How deep, in cells of the other, a feature was inside its solid without a displacement out that it accepts; 0:
    /// none was.
    float stuckDepth() const { return m_stuckDepth; }

private:
    /// Whether features in a box of `from` may come within extent of what is solid.
    bool boxMayTouchSolid(const glm::vec3& low, const glm::vec3& high) {
        const glm::vec3 c = m_corner + m_axes * ((low + high) * 0.5f), h = (high - low) * 0.5f;
        const glm::vec3 r =
            glm::abs(m_axes[0]) * h.x + glm::abs(m_axes[1]) * h.y + glm::abs(m_axes[2]) * h.z + m_maxSearchExtent;
        return m_occupancy.mayContainBrick(floorOf(float4(c - r + m_displacementLow)),
                                           floorOf(float4(c + r + m_displacementHigh)));
    }

    /// The cells of `from` that may come within extent of `into`; false: none.
    bool overlap(CellBox& near) const {
        const glm::mat3 back = glm::transpose(m_axes) / (m_scale * m_scale);
        const glm::vec3 center = back * ((m_low + m_high) * 0.5f - m_corner), half = (m_high - m_low) * 0.5f;
        const glm::vec3 extent = glm::abs(back[0]) * half.x + glm::abs(back[1]) * half.y + glm::abs(back[2]) * half.z;
        const CellBox& own = m_from.bounds();
        const glm::vec3 low = glm::max(glm::floor(center - extent), glm::vec3(own.low)),
                        high = glm::min(glm::ceil(center + extent), glm::vec3(own.high));
        if (!glm::all(glm::lessThan(low, high))) return false;
        near = {Cell(low), Cell(high)};
        // The same the other displacement round: bounds that turn against each other overlap more often than what they
        // hold.
        const glm::vec3 c = m_corner + m_axes * (glm::vec3(near.low + near.high) * 0.5f),
                        h = glm::vec3(near.high - near.low) * 0.5f;
        const glm::vec3 r = glm::abs(m_axes[0]) * h.x + glm::abs(m_axes[1]) * h.y + glm::abs(m_axes[2]) * h.z;
        return glm::all(glm::lessThan(c - r, m_high)) && glm::all(glm::greaterThan(c + r, m_low));
    }

    /// How far around a corner, and around the middles of edges along each axis, something is looked for.
    void setSearchExtents() {
        m_readyKinds = 0;
        glm::vec3 inset = (glm::abs(m_axes[0]) + glm::abs(m_axes[1]) + glm::abs(m_axes[2])) * kInset;
        if (m_sweeps) inset += (std::abs(m_spin.x) + std::abs(m_spin.y) + std::abs(m_spin.z)) * glm::length(inset);
        const glm::vec3 around = inset + (m_margin + kInset * m_scale + kRounding);
        m_searchExtents[0] = float4(around);
        m_maxSearchExtent = around;
        for (int axis = 0; axis < 3; ++axis) {
            const glm::vec3 extent = glm::max(around, glm::abs(m_axes[axis]) * 0.5f + kRounding);
            m_searchExtents[size_t(axis + 1)] = float4(extent);
            m_maxSearchExtent = glm::max(m_maxSearchExtent, extent);
        }
        m_velocity4 = float4(m_velocity), m_spin4 = float4(m_spin), m_about4 = float4(m_about);
    }

    /// The bounds of the ways of features that may meet something: only those that come from where they lead are looked
    /// at.
    void boundSweep() {
        const CellBox& own = m_from.bounds();
        const glm::vec3 c = m_corner + m_axes * (glm::vec3(own.low + own.high) * 0.5f),
                        h = glm::vec3(own.high - own.low) * 0.5f;
        const glm::vec3 r =
            glm::abs(m_axes[0]) * h.x + glm::abs(m_axes[1]) * h.y + glm::abs(m_axes[2]) * h.z + kRounding;
        const glm::vec3 low = glm::max(c - r, m_low) - m_about, high = glm::min(c + r, m_high) - m_about;
        const glm::vec3 displacement = m_velocity + glm::cross(m_spin, (low + high) * 0.5f),
                        half = glm::max((high - low) * 0.5f, 0.0f), s = glm::abs(m_spin);
        const glm::vec3 around(s.y * half.z + s.z * half.y, s.z * half.x + s.x * half.z, s.x * half.y + s.y * half.x);
        m_displacementLow = glm::min(displacement - around, 0.0f) - kRounding;
        m_displacementHigh = glm::max(displacement + around, 0.0f) + kRounding;
        m_low = glm::max(m_low, glm::vec3(m_into.bounds().low) - m_maxSearchExtent - m_displacementHigh);
        m_high = glm::min(m_high, glm::vec3(m_into.bounds().high) + m_maxSearchExtent - m_displacementLow);
    }

    const FeatureQuery& queryFor(uint8_t kind, const glm::vec3& point) {
        FeatureQuery& query = m_queries[kind];
        query.point = point;
        if (m_readyKinds >> kind & 1) return query;
        m_readyKinds |= 1u << kind;
        const FeatureKind& k = featureKinds()[kind];
        query.kind = &k;
        query.sideCount = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (k.outward[axis] != 0.0f) query.sides[query.sideCount++] = m_unit[axis] * k.outward[axis];
        query.along = k.edgeAxis >= 0 ? m_unit[k.edgeAxis] : glm::vec3(0.0f);
        query.length = m_scale;
        m_insets[kind] = m_axes * (k.outward * -kInset);
        return query;
    }

    /// False if nothing that a feature there could meet is solid.
    bool mayTouchSolid(Float4 point, uint8_t kind) {
        const Float4 extent = m_searchExtents[kind < 8 ? 0 : size_t(kind - 4) / 4];
        Float4 low = point - extent, high = point + extent;
        if (m_sweeps) {
            const Float4 displacement = m_velocity4 + cross(m_spin4, point - m_about4);
            low += min4(displacement, float4(0.0f)), high += max4(displacement, float4(0.0f));
        }
        return m_occupancy.mayContainSolid(floorOf(low), floorOf(high));
    }

    /// Features of a region of `from` whose low corner is `corner`.
    void collideFeatures(const FeatureList& features, Cell corner, const CellBox& near,
                         std::vector<ContactPoint>& out) {
        const glm::vec3 base = m_corner + m_axes * glm::vec3(corner), from(near.low - corner), to(near.high - corner);
        const float limit = m_limit - glm::dot(m_direction, glm::vec3(corner));
        std::array<bool, 3> rises{};
        for (int axis = 0; axis < 3; ++axis) rises[size_t(axis)] = m_direction[axis] > 0.0f;
        for (const FeatureList::ClusterPack& clusters : features.clusters) {
            Float4 nearest = float4(0.0f);
            Bool4 inside = {-1, -1, -1, -1};
            for (size_t axis = 0; axis < 3; ++axis) {
                const Float4 low = toFloat4(load(clusters.low[axis])) * float4(0.5f),
                             high = toFloat4(load(clusters.high[axis])) * float4(0.5f);
                nearest += (rises[axis] ? low : high) * float4(m_direction[int(axis)]);
                inside &= (low <= float4(to[int(axis)] + kRounding)) & (high >= float4(from[int(axis)] - kRounding));
            }
            inside &= nearest <= float4(limit);
            if (!any(inside)) continue;
            for (size_t k = 0; k < 4; ++k) {
                if (!inside[k]) continue;
                const glm::vec3 low(clusters.low[0][k], clusters.low[1][k], clusters.low[2][k]);
                const glm::vec3 high(clusters.high[0][k], clusters.high[1][k], clusters.high[2][k]);
                if (boxMayTouchSolid(low * 0.5f + glm::vec3(corner), high * 0.5f + glm::vec3(corner)))
                    collideCluster({features.packs.data() + clusters.from[k], features.packs.data() + clusters.to[k]},
                                   corner, base, limit, out);
            }
        }
    }

    void collideCluster(std::span<const FeatureList::Pack> packs, Cell corner, const glm::vec3& base, float limit,
                        std::vector<ContactPoint>& out) {
        Float4 origin[3], axes[3][3], from[3], to[3],
            along[3];  // what the loop reads, in registers; places are in half cells
        for (int axis = 0; axis < 3; ++axis) {
            origin[axis] = float4(base[axis]), from[axis] = float4(m_low[axis]), to[axis] = float4(m_high[axis]);
            along[axis] = float4(m_direction[axis] * 0.5f);
            for (int k = 0; k < 3; ++k) axes[k][axis] = float4(m_axes[k][axis] * 0.5f);
        }
        for (const FeatureList::Pack& features : packs) {
            const Float4 x = toFloat4(load(features.x)), y = toFloat4(load(features.y)), z = toFloat4(load(features.z));
            Bool4 inside = along[0] * x + along[1] * y + along[2] * z <= float4(limit);
            if (!any(inside)) continue;
            inside &= load(features.kind) < kFeatureKinds;
            Float4 p[3];
            for (int axis = 0; axis < 3; ++axis) {
                p[axis] = origin[axis] + axes[0][axis] * x + axes[1][axis] * y + axes[2][axis] * z;
                inside &= (p[axis] > from[axis]) & (p[axis] < to[axis]);
            }
            if (!any(inside)) continue;
            for (size_t k = 0; k < 4; ++k) {
                if (!inside[k]) continue;
                const uint8_t kind = features.kind[k];
                const Float4 point = {p[0][k], p[1][k], p[2][k], 0.0f};
                if (mayTouchSolid(point, kind))
                    test(queryFor(kind, vec3(point)), kind, corner + FeatureList::cellOf(features, k), out);
            }
        }
    }

    void test(const FeatureQuery& query, uint8_t kind, Cell own, std::vector<ContactPoint>& out) {
        if (query.isEdge()) {
            float from, to;
            if (findSolidInterval(m_occupancy, query, from, to) && collideEdgeCrossing(query, from, to, kind, own, out))
                return;
        }
        const glm::vec3 inset = query.point + m_insets[kind];
        const Cell cell = cellOf(inset);
        Face face = m_occupancy.solid(cell) ? nearestExitFace(m_occupancy, cell, inset, query)
                                            : closestFace(m_occupancy, cell, inset, m_margin + kInset * m_scale, query);
        if (face.axis < 0) {
            if (m_occupancy.solid(cell))
                m_stuckDepth = std::max(m_stuckDepth, depthBelowSurface(m_occupancy, cell, inset));
            if (!m_sweeps) return;
            const glm::vec3 displacement = m_velocity + glm::cross(m_spin, inset - m_about);
            if (glm::dot(displacement, displacement) > m_margin * m_margin)
                face = sweepToFace(m_occupancy, cell, inset, displacement, query);
            if (face.axis < 0) return;
        }
        float extra = 0.0f;  // by which the feature itself is farther in than where it was looked up
        for (int i = 0; i < query.sideCount; ++i) extra += std::max(0.0f, -query.sides[i][face.axis] * face.sign);
        glm::vec3 normal(0.0f);
        normal[face.axis] = face.sign;
        add(query.point, normal, face.separation - extra * kInset * m_scale, kind, own, face.cell, out);
    }

    /// An edge that goes in and out of the solid crosses an edge of it, if there is one that is exposed and out over it
    /// is the shortest displacement: false if not.
    bool collideEdgeCrossing(const FeatureQuery& query, float from, float to, uint8_t kind, Cell own,
                             std::vector<ContactPoint>& out) {
        const glm::vec3 q = query.point + query.along * ((from + to) * 0.5f * query.length);
        const glm::vec3 halfStretch = glm::abs(query.along * ((to - from) * 0.5f * query.length));
        const Cell cell = cellOf(q);
        if (!m_occupancy.solid(cell)) return false;  // an edge that lies in a surface goes in and out by rounding
        // The two exposed faces of q's cell that are closest, if they share an edge that is exposed too.
        Cell signs(0);
        glm::vec3 depth(2.0f);
        for (int axis = 0; axis < 3; ++axis)
            for (const int sign : {-1, 1}) {
                Cell next = cell;
                next[axis] += sign;
                const float d = distanceToSide(cell, q, axis, sign);
                if (d < depth[axis] && !m_occupancy.solid(next)) depth[axis] = d, signs[axis] = sign;
            }
        const int w = depth.x > depth.y ? (depth.x > depth.z ? 0 : 2) : (depth.y > depth.z ? 1 : 2), u = (w + 1) % 3,
                  v = (w + 2) % 3;
        if (!signs[u] || !signs[v]) return false;
        Cell diagonal = cell;
        diagonal[u] += signs[u];
        diagonal[v] += signs[v];
        glm::vec3 edge(0.0f);
        edge[w] = 1.0f;
        glm::vec3 normal = glm::cross(query.along, edge);
        const float length = glm::length(normal);
        if (length < kMinEdgeSine || m_occupancy.solid(diagonal)) return false;
        normal /= length;
        float alongU = normal[u] * float(signs[u]), alongV = normal[v] * float(signs[v]);
        if (alongU + alongV < 0) normal = -normal, alongU = -alongU, alongV = -alongV;
        if (alongU < -kMaxSideCosine || alongV < -kMaxSideCosine || !query.accepts(normal)) return false;
        // Out over a face is shorter if no end of the stretch is deep behind it.
        if (depth[u] * alongU + depth[v] * alongV > std::min(depth[u] + halfStretch[u], depth[v] + halfStretch[v]))
            return false;
        add(q, normal, -(depth[u] * alongU + depth[v] * alongV), kind, own, cell, out);
        return true;
    }

    void add(const glm::vec3& point, const glm::vec3& normal, float separation, uint8_t kind, Cell own, Cell other,
             std::vector<ContactPoint>& out) {
        ContactPoint contact;
        const float size = float(m_into.voxelSize());
        const glm::vec3 middle = point - normal * (separation * 0.5f);
        contact.position = glm::vec3(m_intoCells.axes * glm::dvec3(middle) + m_intoCells.corner);
        contact.normal = glm::vec3(m_intoCells.axes * glm::dvec3(normal)) / (m_isFirst ? size : -size);
        contact.separation = separation * size;
        const uint8_t a = m_from.grid().at(own), b = m_into.grid().at(other);
        contact.friction = std::sqrt(m_from.contactMaterials().friction[a] * m_into.contactMaterials().friction[b]);
        contact.restitution =
            std::sqrt(m_from.contactMaterials().restitution[a] * m_into.contactMaterials().restitution[b]);
        contact.feature = m_key | uint64_t(uint32_t(own.x)) << 41 | uint64_t(uint32_t(own.y)) << 29 |
                          uint64_t(uint32_t(own.z)) << 17 | uint64_t(kind) << 12;
        out.push_back(contact);
    }

    const VoxelPart& m_from;
    const VoxelPart& m_into;
    Occupancy m_occupancy;
    CellTransform m_intoCells;
    glm::mat3 m_axes;    ///< of a cell of `from`, in cells of `into`
    glm::vec3 m_corner;  ///< of `from`, in cells of `into`
    float m_scale;       ///< cells of `into` that a cell of `from` is long
    std::array<glm::vec3, 3> m_unit;
    uint32_t m_readyKinds = 0;          ///< kinds whose probes are ready
    glm::vec3 m_maxSearchExtent{0.0f};  ///< of the reaches
    Float4 m_velocity4, m_spin4, m_about4;
    std::array<Float4, 4> m_searchExtents;  ///< of corners and of edges along x, y, z
    std::array<FeatureQuery, kFeatureKinds> m_queries;
    std::array<glm::vec3, kFeatureKinds> m_insets;
    float m_margin, m_searchDistance = 0.0f;
    bool m_sweeps = false, m_isFirst = true;
    float m_stuckDepth = 0.0f;
    uint64_t m_key = 0;
    glm::vec3 m_velocity{0.0f}, m_spin{0.0f}, m_about{0.0f};
    glm::vec3 m_direction{0.0f};                                  ///< in cells of `from`
    float m_limit = 1e30f;                                        ///< beyond which along it nothing is met
    glm::vec3 m_displacementLow{0.0f}, m_displacementHigh{0.0f};  ///< bounds of the ways of features in the step, and 0
    glm::vec3 m_low, m_high;                                      ///< where features may meet `into`, in its cells
};

/// How the first body moves against the second.
struct RelativeMotion {
    RelativeMotion(const Motion& first, const Motion& second, const NarrowphaseSettings& settings)
        : seconds(settings.seconds) {
        apart = second.pose.position - first.pose.position;
        // v1 + w1 x r - (v2 + w2 x (r - apart))
        velocity = first.velocity - second.velocity + glm::cross(second.angularVelocity, apart);
        spin = first.angularVelocity - second.angularVelocity;
        displacement = maxRelativeDisplacement(first, second, seconds);
        sweeps = displacement > settings.sweepThreshold;
        if (second.radius == 0.0 || first.radius < second.radius)
            radius = first.radius, central = velocity;
        else
            radius = second.radius, central = velocity + glm::cross(spin, apart);
    }
    /// The most that what may meet comes closer in the step along a unit vector from the second to the first, metres.
    /// around: metres from a feature in which it is looked for.
    float closing(const glm::vec3& axis, double around) const {
        if (!sweeps) return 0.0f;
        const double straight = -glm::dot(glm::dvec3(axis), central),
                     turning = glm::length(glm::cross(glm::dvec3(axis), spin)) * (radius + displacement + around);
        return float(std::clamp((straight + turning) * seconds, 0.0, displacement));
    }

    double seconds;
    glm::dvec3 apart{0.0};     ///< from the first's frame origin to the second's, world axes
    glm::dvec3 velocity{0.0};  ///< of the first at its origin against the second, world axes
    glm::dvec3 spin{0.0};
    double displacement = 0.0;  ///< the longest that a point of them moves against the other, metres
    bool sweeps = false;
    double radius = 0.0;      ///< of the min4
    glm::dvec3 central{0.0};  ///< the velocity at its origin
};

TransformedHull transformHull(const VoxelPart& part, const CellTransform& cells) {
    return {part.hull(), glm::mat3(cells.axes), glm::vec3(cells.corner)};
}

/// From the middle of one part to that of the other.
glm::vec3 centerAxis(const VoxelPart& to, const TransformedHull& toHull, const VoxelPart& from,
                     const TransformedHull& fromHull) {
    const auto middle = [](const VoxelPart& part, const TransformedHull& hull) {
        return hull.corner + hull.axes * (glm::vec3(part.bounds().low + part.bounds().high) * 0.5f);
    };
    const glm::vec3 displacement = middle(to, toHull) - middle(from, fromHull);
    const float length2 = glm::dot(displacement, displacement);
    return length2 > 1e-12f ? displacement / std::sqrt(length2) : glm::vec3(0.0f, 1.0f, 0.0f);
}

/// Which displacement two with a stuck feature are pushed apart: along the hulls' axis if they have no contacts, else
/// as these push on the whole, or both would spin what lies centerAxis. Zero: not at all.
glm::vec3 pushDirection(std::span<const ContactPoint> contacts, const glm::vec3& axis, float stuckDepth) {
    if (contacts.empty()) return axis;
    glm::vec3 sum(0.0f);
    for (const ContactPoint& contact : contacts) sum += contact.normal;
    const float length = glm::length(sum);
    return stuckDepth > kMinStuckDepth && length > kMinAgreement * float(contacts.size()) ? sum / length
                                                                                          : glm::vec3(0.0f);
}

/// For two that overlap so that none of their features accepts a displacement out: apart along the axis, at the middle
/// of what their bounds share, no harder than from half a voxel deep.
ContactPoint stuckContact(const VoxelPart& a, const TransformedHull& hullA, const VoxelPart& b,
                          const TransformedHull& hullB, const glm::vec3& axis, float gap, uint64_t key) {
    glm::vec3 lowA, highA, lowB, highB;
    hullA.points.bounds(hullA.axes, lowA, highA);
    hullB.points.bounds(hullB.axes, lowB, highB);
    const glm::vec3 low = glm::max(hullA.corner + lowA, hullB.corner + lowB),
                    high = glm::min(hullA.corner + highA, hullB.corner + highB);
    ContactPoint contact;
    contact.position = (low + high) * 0.5f;
    contact.normal = axis;
    contact.separation = std::max(gap, -0.5f * float(std::min(a.voxelSize(), b.voxelSize())));
    contact.feature = key | uint64_t(kFeatureKinds) << 12;
    return contact;
}

}  // namespace

double maxRelativeDisplacement(const Motion& first, const Motion& second, double seconds) {
    return (glm::length(first.velocity - second.velocity) + glm::length(first.angularVelocity) * first.radius +
            glm::length(second.angularVelocity) * second.radius) *
           seconds;
}

bool findContacts(const VoxelCollider& first, const Motion& firstMotion, const VoxelCollider& second,
                  const Motion& secondMotion, const NarrowphaseSettings& settings, glm::vec3& axis,
                  std::vector<ContactPoint>& out) {
    const RelativeMotion approach(firstMotion, secondMotion, settings);
    bool isNear = false;
    const bool isOne = first.parts.size() == 1 && second.parts.size() == 1;
    for (size_t i = 0; i < first.parts.size(); ++i)
        for (size_t j = 0; j < second.parts.size(); ++j) {
            const VoxelPart &a = *first.parts[i], &b = *second.parts[j];
            if (a.grid().empty() || b.grid().empty() || !a.filter().meets(b.filter())) continue;
            const CellTransform& la = firstMotion.cellTransforms[i];
            const CellTransform lb{secondMotion.cellTransforms[j].axes,
                                   secondMotion.cellTransforms[j].corner + approach.apart};
            const TransformedHull hullA = transformHull(a, la), hullB = transformHull(b, lb);
            const bool isKnown = isOne && axis != glm::vec3(0.0f);
            glm::vec3 displacement = isKnown ? axis : centerAxis(a, hullA, b, hullB);
            const float size = float(std::max(a.voxelSize(), b.voxelSize()));
            const float most = float(settings.margin) + kSearchDistance * size,
                        closing = approach.sweeps ? float(approach.displacement) : 0.0f;
            const float gap = refineSeparatingAxis(hullA, hullB, most + closing,
                                                   isKnown ? kKnownPairIterations : kNewPairIterations, displacement);
            if (isOne) axis = displacement;
            const float near = most + approach.closing(displacement, double(most));
            if (gap > near) continue;
            isNear = true;
            const size_t before = out.size();
            const uint64_t key = uint64_t(i & 31) << 6 | uint64_t(j & 31) << 1;
            FeatureCollider forward(a, la, b, lb);
            forward.setMotion(approach.velocity, approach.spin, settings, approach.displacement);
            forward.setLimit(displacement, hullB.support(displacement) + near, la);
            if (!forward.run(true, key, out)) continue;
            FeatureCollider backward(b, lb, a, la);
            backward.setMotion(-approach.velocity, -approach.spin, settings, approach.displacement);
            backward.setLimit(-displacement, hullA.support(-displacement) + near, lb);
            backward.run(false, key | 1, out);
            if (const float stuck = std::max(forward.stuckDepth(), backward.stuckDepth()); stuck > 0.0f && gap < 0.0f) {
                const glm::vec3 apart = pushDirection({out.data() + before, out.size() - before}, displacement, stuck);
                if (apart != glm::vec3(0.0f)) out.push_back(stuckContact(a, hullA, b, hullB, apart, gap, key));
            }
        }
    return isNear;
}

}  // namespace rubble
