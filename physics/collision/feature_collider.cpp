#include "physics/collision/feature_collider.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "runtime/core/rotated_box.h"

namespace rubble {
namespace {

/// Cells of its own by which a feature is looked up inside its own solid, so that edges that line up still meet.
constexpr float kInset = 0.05f;
constexpr float kRounding = 1e-3f;     ///< cells added to bounds against rounding
constexpr float kMinEdgeSine = 0.15f;  ///< between two edges below which they count as parallel
constexpr float kUpright = 0.995f;     ///< cosine between an edge and a normal from which it stands on the face
constexpr float kMaxTilt = 0.1f;       ///< cosine between an edge and a normal up to which it lies along the face

/// Whether an edge that stands on a face reaches into it with its end only, and not as far as corners are looked up
/// inside of their own solid.
bool isTip(const FeatureQuery& query, float from, float to) {
    const glm::vec3 along = glm::abs(query.along);
    return (to - from) * query.length < kInset && (from <= -0.5f || to >= 0.5f) &&
           std::max({along.x, along.y, along.z}) > kUpright;
}

/// A stride that visits all of `count` places, those of each prefix far from each other: the nearest to the golden
/// section that has no common divisor with `count`.
uint64_t spreadStride(uint64_t count) {
    uint64_t stride = std::max<uint64_t>(1, uint64_t(double(count) * 0.6180339887));
    while (std::gcd(stride, count) != 1) ++stride;
    return stride;
}

}  // namespace

FeatureCollider::FeatureCollider(const CoveredPart& from, const CoveredPart& into)
    : m_from(from.part),
      m_into(into.part),
      m_fromCover(from.cover),
      m_occupancy(into.part, into.cover),
      m_intoCells(into.cells),
      m_axes(metresToCells(into.cells, into.part.voxelSize()) * from.cells.axes),
      m_axes4(m_axes),
      m_absoluteAxes4(glm::mat3(glm::abs(m_axes[0]), glm::abs(m_axes[1]), glm::abs(m_axes[2]))),
      m_margin(0) {
    const double size = m_into.voxelSize();
    const glm::dmat3 toInto = metresToCells(into.cells, size);
    m_corner = glm::vec3(toInto * (from.cells.corner - into.cells.corner));
    m_scale = float(m_from.voxelSize() / size);
    for (int i = 0; i < 3; ++i) m_unit[i] = m_axes[i] / m_scale;
}

void FeatureCollider::setMotion(glm::dvec3 velocity, glm::dvec3 spin, const NarrowphaseSettings& settings,
                                double maxDisplacement) {
    const double size = m_into.voxelSize();
    m_margin = std::min(float(settings.margin / size), kMaxContactMargin);
    m_sweeps = maxDisplacement > settings.sweepThreshold;
    m_searchDistance = m_margin + (m_sweeps ? float(maxDisplacement / size) : 0.0f);
    const glm::dmat3 toInto = metresToCells(m_intoCells, size);
    m_velocity = glm::vec3(toInto * velocity) * float(settings.seconds);
    m_spin = glm::vec3(glm::transpose(m_intoCells.axes) * spin / size) * float(settings.seconds);
    m_about = glm::vec3(toInto * -m_intoCells.corner);
}

void FeatureCollider::setLimit(const glm::vec3& direction, float limit, const CellTransform& fromCells) {
    m_direction = direction * glm::mat3(fromCells.axes);
    m_limit = limit - glm::dot(direction, glm::vec3(fromCells.corner)) +
              0.5f * std::max({std::abs(m_direction.x), std::abs(m_direction.y), std::abs(m_direction.z)});
}

bool FeatureCollider::collide(bool isFirst, uint64_t partKey, ContactSearch& search, std::vector<ContactPoint>& out) {
    m_isFirst = isFirst;
    m_key = partKey;
    m_low = glm::vec3(m_into.bounds().low) - m_searchDistance;
    m_high = glm::vec3(m_into.bounds().high) + m_searchDistance;
    CellBox near;
    if (!findOverlap(near)) return false;
    setSearchExtents();
    if (m_sweeps) boundSweep();
    if (!mayTouchSolid(near)) return false;
    if (const PartSurface* surface = m_from.whole()) {
        collideFeatures(surface->features(), surface->rows.box().low, near, out);
        return true;
    }
    collideBricks(near, search, out);
    return true;
}

/// The bricks of `from` in an order that is spread over them at any time, until there are enough contacts or bricks.
void FeatureCollider::collideBricks(const CellBox& near, ContactSearch& search, std::vector<ContactPoint>& out) {
    const Cell low = brickOfCell(near.low), size = brickOfCell(near.high - 1) - low + 1;
    const uint64_t count = uint64_t(size.x) * uint64_t(size.y) * uint64_t(size.z), stride = spreadStride(count);
    const size_t enough = out.size() + kEnoughContacts;
    const uint64_t first = search.turn * kMaxSearchedBricks % count * stride % count;
    size_t searched = 0;
    for (uint64_t i = 0, at = first; i < count && out.size() < enough; ++i, at = (at + stride) % count) {
        const Cell brick = low + Cell(at % uint64_t(size.x), at / uint64_t(size.x) % uint64_t(size.y),
                                      at / uint64_t(size.x) / uint64_t(size.y)),
                   corner = brick * kBrickSize;
        if (!m_from.grid().brickAt(brick) ||
            !boxMayTouchSolid(float4(glm::vec3(glm::max(near.low - 1, corner))),
                              float4(glm::vec3(glm::min(near.high + 1, corner + kBrickSize)))))
            continue;
        if (searched++ < kMaxSearchedBricks)
            collideFeatures(m_from.features(brick), corner, near, out);
        else
            ++search.leftOut;
    }
}

/// Conservative: whether the shapes may touch within the step where `from` has these cells. The features of `into` too,
/// whose displacements are others.
bool FeatureCollider::mayTouchSolid(const CellBox& near) {
    const glm::vec3 c = m_corner + m_axes * (glm::vec3(near.low + near.high) * 0.5f);
    const glm::vec3 r = rotatedHalfExtent(m_axes, glm::vec3(near.high - near.low) * 0.5f) + m_maxSearchExtent;
    return m_occupancy.mayContainBrick(floorOf(float4(c - r + m_displacementLow)),
                                       floorOf(float4(c + r + m_displacementHigh)));
}

/// Conservative: whether features in a box of cells of `from` may touch a solid cell of `into` within the step.
bool FeatureCollider::boxMayTouchSolid(Float4 low, Float4 high) {
    const Float4 c = m_corner4 + m_axes4 * ((low + high) * 0.5f),
                 r = m_absoluteAxes4 * ((high - low) * 0.5f) + m_maxSearchExtent4;
    if (!m_sweeps) return m_occupancy.mayContainBrick(floorOf(c - r), floorOf(c + r));
    // The features' displacements differ by at most `around` from that of the box's centre.
    const Float4 displacement = m_velocity4 + cross(m_spin4, c - m_about4), s = abs4(m_spin4),
                 around = __builtin_shufflevector(s, s, 1, 2, 0, 3) * __builtin_shufflevector(r, r, 2, 0, 1, 3) +
                          __builtin_shufflevector(s, s, 2, 0, 1, 3) * __builtin_shufflevector(r, r, 1, 2, 0, 3) +
                          kRounding;
    if (!pathMeetsBounds(c, r + around, displacement)) return false;
    return m_occupancy.mayContainBrick(floorOf(c - r + min4(displacement - around, Float4{})),
                                       floorOf(c + r + max4(displacement + around, Float4{})));
}

/// Whether a box (centre and half size) that moves on a straight line overlaps the box around the cells of `into`.
bool FeatureCollider::pathMeetsBounds(Float4 center, Float4 half, Float4 displacement) const {
    const CellBox& bounds = m_into.bounds();
    const Float4 low = float4(glm::vec3(bounds.low)) - half - center,
                 high = float4(glm::vec3(bounds.high)) + half - center, rounding = float4(kRounding);
    const Bool4 isStill = abs4(displacement) < rounding;  // so is the last lane, in which all is about 0
    if (any(isStill & ((low > rounding) | (high < -rounding)))) return false;
    const Float4 inverse = 1.0f / (isStill ? float4(1.0f) : displacement), enter = low * inverse,
                 leave = high * inverse, from = isStill ? Float4{} : min4(enter, leave),
                 to = isStill ? float4(1.0f) : max4(enter, leave);
    return std::max({from[0], from[1], from[2], 0.0f}) <= std::min({to[0], to[1], to[2], 1.0f}) + kRounding;
}

/// The cells of `from` within the search box of `into`; false: none.
bool FeatureCollider::findOverlap(CellBox& near) const {
    const glm::mat3 back = glm::transpose(m_axes) / (m_scale * m_scale);
    const glm::vec3 center = back * ((m_low + m_high) * 0.5f - m_corner), half = (m_high - m_low) * 0.5f;
    const glm::vec3 extent = rotatedHalfExtent(back, half);
    const CellBox& own = m_from.bounds();
    const glm::vec3 low = glm::max(glm::floor(center - extent), glm::vec3(own.low)),
                    high = glm::min(glm::ceil(center + extent), glm::vec3(own.high));
    if (!glm::all(glm::lessThan(low, high))) return false;
    near = {Cell(low), Cell(high)};
    // The same test with the roles exchanged: the bounds of rotated boxes overlap more often than the boxes do.
    const glm::vec3 c = m_corner + m_axes * (glm::vec3(near.low + near.high) * 0.5f),
                    h = glm::vec3(near.high - near.low) * 0.5f;
    const glm::vec3 r = rotatedHalfExtent(m_axes, h);
    return glm::all(glm::lessThan(c - r, m_high)) && glm::all(glm::greaterThan(c + r, m_low));
}

/// How far around a corner, and around the middle of an edge along each axis, solid cells matter.
void FeatureCollider::setSearchExtents() {
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
    m_corner4 = float4(m_corner), m_maxSearchExtent4 = float4(m_maxSearchExtent);
}

/// Bounds the displacements of the features that may meet something, and narrows the search box to the side that they
/// come from.
void FeatureCollider::boundSweep() {
    const CellBox& own = m_from.bounds();
    const glm::vec3 c = m_corner + m_axes * (glm::vec3(own.low + own.high) * 0.5f),
                    h = glm::vec3(own.high - own.low) * 0.5f;
    const glm::vec3 r = rotatedHalfExtent(m_axes, h) + kRounding;
    const glm::vec3 low = glm::max(c - r, m_low) - m_about, high = glm::min(c + r, m_high) - m_about;
    const glm::vec3 displacement = m_velocity + glm::cross(m_spin, (low + high) * 0.5f),
                    half = glm::max((high - low) * 0.5f, 0.0f), s = glm::abs(m_spin);
    const glm::vec3 around(s.y * half.z + s.z * half.y, s.z * half.x + s.x * half.z, s.x * half.y + s.y * half.x);
    m_displacementLow = glm::min(displacement - around, 0.0f) - kRounding;
    m_displacementHigh = glm::max(displacement + around, 0.0f) + kRounding;
    m_low = glm::max(m_low, glm::vec3(m_into.bounds().low) - m_maxSearchExtent - m_displacementHigh);
    m_high = glm::min(m_high, glm::vec3(m_into.bounds().high) + m_maxSearchExtent - m_displacementLow);
}

/// The query of a kind at a point. All but the point is computed once.
FeatureQuery& FeatureCollider::queryFor(uint8_t kind, const glm::vec3& point) {
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

/// Conservative: which of four features may touch a solid cell within the step. points: their x, y and z. lanes: bits
/// of those to look at.
uint32_t FeatureCollider::mayTouchSolid(const std::array<Float4, 3>& points, const std::array<uint8_t, 4>& kinds,
                                        uint32_t lanes) {
    const auto extentOf = [&](uint8_t kind) { return m_searchExtents[kind < 8 ? 0 : size_t(kind - 4) / 4 & 3]; };
    const std::array<Float4, 3> extents =
        transposed({extentOf(kinds[0]), extentOf(kinds[1]), extentOf(kinds[2]), extentOf(kinds[3])});
    std::array<Int4, 3> low, high;
    std::array<Float4, 3> from;
    if (m_sweeps)
        for (int axis = 0; axis < 3; ++axis) from[size_t(axis)] = points[size_t(axis)] - m_about[axis];
    for (size_t axis = 0; axis < 3; ++axis) {
        Float4 least = points[axis] - extents[axis], most = points[axis] + extents[axis];
        if (m_sweeps) {
            const size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            const Float4 displacement = m_velocity[int(axis)] + (m_spin[int(u)] * from[v] - m_spin[int(v)] * from[u]);
            least += min4(displacement, Float4{}), most += max4(displacement, Float4{});
        }
        low[axis] = floorOf(least), high[axis] = floorOf(most);
    }
    return m_occupancy.mayContainSolid(low, high, lanes);
}

/// The features of a region of `from`, four clusters at a time. corner: of the region.
void FeatureCollider::collideFeatures(const FeatureList& features, Cell corner, const CellBox& near,
                                      std::vector<ContactPoint>& out) {
    const glm::vec3 base = m_corner + m_axes * glm::vec3(corner), from(near.low - corner), to(near.high - corner);
    const float limit = m_limit - glm::dot(m_direction, glm::vec3(corner));
    const Float4 corner4 = float4(glm::vec3(corner));
    std::array<bool, 3> rises{};
    for (int axis = 0; axis < 3; ++axis) rises[size_t(axis)] = m_direction[axis] > 0.0f;
    for (const FeatureList::ClusterPack& clusters : features.clusters) {
        std::array<Float4, 3> low, high;
        Float4 nearest = float4(0.0f);
        Bool4 inside = {-1, -1, -1, -1};
        for (size_t axis = 0; axis < 3; ++axis) {
            low[axis] = toFloat4(load(clusters.low[axis])) * 0.5f;
            high[axis] = toFloat4(load(clusters.high[axis])) * 0.5f;
            nearest += (rises[axis] ? low : high)[axis] * m_direction[int(axis)];
            inside &= (low[axis] <= to[int(axis)] + kRounding) & (high[axis] >= from[int(axis)] - kRounding);
        }
        inside &= nearest <= limit;
        uint32_t lanes = bitsOf(inside);
        if (!lanes) continue;
        const std::array<Float4, 4> lows = transposed(low[0], low[1], low[2]),
                                    highs = transposed(high[0], high[1], high[2]);
        for (; lanes; lanes &= lanes - 1) {
            const auto k = size_t(std::countr_zero(lanes));
            if (boxMayTouchSolid(lows[k] + corner4, highs[k] + corner4))
                collideCluster({features.packs.data() + clusters.from[k], features.packs.data() + clusters.to[k]},
                               corner, base, limit, out);
        }
    }
}

/// The features of a cluster, four at a time.
void FeatureCollider::collideCluster(std::span<const FeatureList::Pack> packs, Cell corner, const glm::vec3& base,
                                     float limit, std::vector<ContactPoint>& out) {
    Float4 origin[3], axes[3][3], from[3], to[3], along[3];  // in registers; features are in half cells
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
        std::array<Float4, 3> p;
        for (size_t axis = 0; axis < 3; ++axis) {
            p[axis] = origin[axis] + axes[0][axis] * x + axes[1][axis] * y + axes[2][axis] * z;
            inside &= (p[axis] > from[axis]) & (p[axis] < to[axis]);
        }
        uint32_t lanes = bitsOf(inside);
        if (lanes) lanes = mayTouchSolid(p, features.kind, lanes);
        for (; lanes; lanes &= lanes - 1) {
            const auto k = size_t(std::countr_zero(lanes));
            const uint8_t kind = features.kind[k];
            collideFeature(queryFor(kind, {p[0][k], p[1][k], p[2][k]}), kind, corner + FeatureList::cellOf(features, k),
                           out);
        }
    }
}

/// Finds on which sides of a feature something lies against `from`; false: on all, so that nothing can touch it. own:
/// the cell that it belongs to.
bool FeatureCollider::findCoveredSides(FeatureQuery& query, Cell own) {
    const glm::vec3 point = glm::vec3(own) + query.kind->offset;
    query.covered = 0;
    for (int axis = 0, i = 0; axis < 3; ++axis) {
        if (query.kind->outward[axis] == 0.0f) continue;
        if (m_fromCover->covers(own, point, axis, query.kind->outward[axis] > 0.0f ? 1 : -1)) query.covered |= 1u << i;
        ++i;
    }
    return query.covered != (1u << query.sideCount) - 1;
}

/// One feature. own: the cell of `from` that it belongs to.
void FeatureCollider::collideFeature(FeatureQuery& query, uint8_t kind, Cell own, std::vector<ContactPoint>& out) {
    if (m_fromCover && !findCoveredSides(query, own)) return;
    const glm::vec3 inset = query.point + m_insets[kind];
    const Cell cell = cellOf(inset);
    const bool isInside = m_occupancy.solid(cell);
    float from, to;
    const bool crosses = query.isEdge() && findSolidInterval(m_occupancy, query, from, to) &&
                         collideEdgeCrossing(query, from, to, kind, own, out);
    Face face;
    if (!crosses) {
        face = isInside ? nearestExitFace(m_occupancy, cell, inset, query)
                        : closestFace(m_occupancy, cell, inset, m_margin + kInset * m_scale, query);
        if (face.axis >= 0)
            addFace(query, face, kind, own, out);
        else if (isInside)
            m_stuckDepth = std::max(m_stuckDepth, depthBelowSurface(m_occupancy, cell, inset));
    }
    if (!m_sweeps) return;
    // What it touches is not all that is on its way: it may slide along a wall towards another.
    const glm::vec3 displacement = m_velocity + glm::cross(m_spin, inset - m_about);
    if (glm::dot(displacement, displacement) <= m_margin * m_margin) return;
    const Face ahead = sweepToFace(m_occupancy, cell, inset, displacement, query);
    if (ahead.axis >= 0 && (ahead.axis != face.axis || ahead.sign != face.sign)) addFace(query, ahead, kind, own, out);
}

void FeatureCollider::addFace(const FeatureQuery& query, const Face& face, uint8_t kind, Cell own,
                              std::vector<ContactPoint>& out) {
    float extra = 0.0f;  // insets by which the feature itself is deeper than the point that was looked up
    for (int i = 0; i < query.sideCount; ++i) extra += std::max(0.0f, -query.sides[i][face.axis] * face.sign);
    glm::vec3 normal(0.0f);
    normal[face.axis] = face.sign;
    add(query.point, normal, face.separation - extra * kInset * m_scale, kind, own, face.cell, out);
}

/// Edge against edge: an edge that is inside the solid from `from` to `to` crosses an exposed edge of it, and leaving
/// across that edge is the shortest exit. The normal is the cross product of the two edges. False if it is not so.
bool FeatureCollider::collideEdgeCrossing(const FeatureQuery& query, float from, float to, uint8_t kind, Cell own,
                                          std::vector<ContactPoint>& out) {
    const glm::vec3 q = query.point + query.along * ((from + to) * 0.5f * query.length);
    const glm::vec3 halfInterval = glm::abs(query.along * ((to - from) * 0.5f * query.length));
    const Cell cell = cellOf(q);
    if (!m_occupancy.solid(cell)) return false;  // an edge that lies in a surface goes in and out by rounding
    // The two exposed faces of q's cell that are closest, if they share an edge that is exposed too.
    Cell signs(0);
    glm::vec3 depth(2.0f);
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            const float d = distanceToSide(cell, q, axis, sign);
            if (d < depth[axis] && m_occupancy.exposed(cell, q, axis, sign)) depth[axis] = d, signs[axis] = sign;
        }
    const int w = depth.x > depth.y ? (depth.x > depth.z ? 0 : 2) : (depth.y > depth.z ? 1 : 2);
    const int u = (w + 1) % 3, v = (w + 2) % 3;
    if (!signs[u] || !signs[v]) return false;
    Cell diagonal = cell;
    diagonal[u] += signs[u];
    diagonal[v] += signs[v];
    glm::vec3 edge(0.0f);
    edge[w] = 1.0f;
    glm::vec3 normal = glm::cross(query.along, edge);
    const float length = glm::length(normal);
    if (length < kMinEdgeSine || !m_occupancy.open(diagonal)) return false;
    normal /= length;
    float alongU = normal[u] * float(signs[u]), alongV = normal[v] * float(signs[v]);
    if (alongU + alongV < 0) normal = -normal, alongU = -alongU, alongV = -alongV;
    if (alongU < -kMaxSideCosine || alongV < -kMaxSideCosine || !query.accepts(normal)) return false;
    // The exit through one face is shorter if neither end of the interval is deep behind it.
    const float exitDepth = depth[u] * alongU + depth[v] * alongV;
    bool isShortest = exitDepth <= std::min(depth[u] + halfInterval[u], depth[v] + halfInterval[v]);
    if (exitDepth < kInset) {
        // What slides over a gap overlaps the edge beyond it by a hair: motion tells which side it came from.
        glm::vec3 lift(0.0f);
        if (isTip(query, from, to))
            lift = query.along * (to < 0.5f ? 1.0f : -1.0f);
        else if (depth[w] < kInset && std::abs(query.along[w]) < kMaxTilt)
            lift[w] = float(signs[w]);
        const glm::vec3 displacement = m_velocity + glm::cross(m_spin, q - m_about);
        const float difference = glm::dot(displacement, normal - lift);
        if (lift != glm::vec3(0.0f) && std::abs(difference) > kMinSlide) isShortest = difference > 0.0f;
    }
    if (!isShortest) return false;
    add(q, normal, -exitDepth, kind, own, cell, out);
    return true;
}

/// Appends a contact. point and normal are in cells of `into`; the contact lies midway between the two surfaces.
void FeatureCollider::add(const glm::vec3& point, const glm::vec3& normal, float separation, uint8_t kind, Cell own,
                          Cell other, std::vector<ContactPoint>& out) {
    ContactPoint contact;
    const float size = float(m_into.voxelSize());
    const glm::vec3 middle = point - normal * (separation * 0.5f);
    contact.position = glm::vec3(m_intoCells.axes * glm::dvec3(middle) + m_intoCells.corner);
    contact.normal = glm::vec3(m_intoCells.axes * glm::dvec3(normal)) / (m_isFirst ? size : -size);
    contact.separation = separation * size;
    const uint8_t a = m_from.entryAt(own), b = m_into.entryAt(other);
    const ContactMaterials &fromMaterials = m_from.contactMaterials(), &intoMaterials = m_into.contactMaterials();
    contact.friction = std::sqrt(fromMaterials.friction[a] * intoMaterials.friction[b]);
    contact.restitution = std::sqrt(fromMaterials.restitution[a] * intoMaterials.restitution[b]);
    contact.feature = m_key | uint64_t(uint32_t(own.x)) << 41 | uint64_t(uint32_t(own.y)) << 29 |
                      uint64_t(uint32_t(own.z)) << 17 | uint64_t(kind) << 12;
    out.push_back(contact);
}

}  // namespace rubble
