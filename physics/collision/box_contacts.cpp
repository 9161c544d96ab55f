#include "physics/collision/box_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "physics/math/simd4.h"

// Contacts of two boxes, by separating axes.
//
// Two convex polyhedra are apart exactly if a plane across one of a few axes separates them; for boxes these are the
// three normals of each and the nine cross products of their edges (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH
// 1996). The axis of the widest gap, or of the least overlap, is the normal:
//   1. A face against a box: the other's face that is the most opposed is clipped to the sides of the first (Sutherland
//      and Hodgman, "Reentrant Polygon Clipping", 1974). What is left near the face are the contacts.
//   2. An edge against an edge: the points at which the two lines are the nearest.
// Boxes that move fast and are apart are first taken along a straight line to where they meet, if they do: each axis
// has an interval of time in which its projections overlap, and the last of them to begin is the normal. The contacts
// are found there and taken back. The boxes' spins are bounded by a wider margin.

namespace rubble {
namespace {

/// Voxels by which an edge against an edge must be less deep than a face, and a face of the first than one of the
/// second, to be preferred: else the choice would flicker.
constexpr float kPreference = 0.02f;
/// Voxels up to which boxes may overlap along an axis and slide past each other, if kMinSlide tells that they do.
constexpr float kHair = 0.05f;
constexpr float kShared = 0.995f;         ///< cosine from which two normals count as one
constexpr float kMinEdgeSine2 = 0.0225f;  ///< squared sine between edges below which they count as parallel
constexpr float kParallel = 1e-6f;        ///< added to cosines against the rounding of parallel axes
constexpr float kGapRounding = 1e-4f;     ///< metres, against that of gaps
constexpr float kApart = -1e30f;          ///< a separation that is never the widest
constexpr uint32_t kNoCode = 31;
constexpr size_t kMaxCorners = 8;

/// A box in world axes, metres from the first body's frame origin.
struct Box {
    const ColliderPart& part;
    const BoxSurface& surface;
    glm::vec3 center;
    std::array<glm::vec3, 3> axes;  ///< unit vectors
    glm::vec3 half;

    explicit Box(const MovingPart& moving) : part(moving.part), surface(*moving.part.box()) {
        const float size = float(part.voxelSize());
        const glm::mat3 cells(moving.cells.axes);
        center = glm::vec3(moving.cells.corner) + cells * surface.center;
        half = surface.half * size;
        for (int i = 0; i < 3; ++i) axes[size_t(i)] = cells[i] / size;
    }
    float diagonal() const { return std::sqrt(glm::dot(half, half)); }
    glm::vec3 alongAxes(const glm::vec3& v) const {
        return {glm::dot(v, axes[0]), glm::dot(v, axes[1]), glm::dot(v, axes[2])};
    }
    glm::vec3 toWorld(const glm::vec3& v) const { return axes[0] * v.x + axes[1] * v.y + axes[2] * v.z; }
    /// The palette entry of the voxel at a point on its surface.
    uint8_t entryAt(const glm::vec3& point) const {
        if (part.whole()->entry) return part.whole()->entry;
        const glm::vec3 cell = surface.center + alongAxes(point - center) / float(part.voxelSize());
        return part.grid().at(glm::clamp(cellAt(cell), part.bounds().low, part.bounds().high - 1));
    }
};

/// The number of an edge along an axis among the features of a box (surface_features.h). corner: of one of its ends;
/// bit i is set if it is on the high side of axis i.
uint32_t edgeCode(int axis, uint32_t corner) {
    return 8 + 4 * uint32_t(axis) + (corner >> (axis + 1) % 3 & 1) + 2 * (corner >> (axis + 2) % 3 & 1);
}

Float4 multiplied(const std::array<Float4, 3>& columns, const glm::vec3& v) {
    return columns[0] * float4(v.x) + columns[1] * float4(v.y) + columns[2] * float4(v.z);
}

/// The 15 axes: the faces of the first (lanes of group 0), of the second (1), and the edges of the first with those of
/// the second (2 to 4, lanes by edge of the second).
class AxisTest {
public:
    static constexpr size_t kGroups = 5;
    using Projections = std::array<Float4, kGroups>;
    /// An axis by its number: 4 * group + lane.
    struct Best {
        int axis = -1;
        float separation = kApart;
    };

    AxisTest(const Box& a, const Box& b) : m_a(a), m_b(b) {
        for (size_t i = 0; i < 3; ++i)
            m_rows[i] = Float4{glm::dot(a.axes[i], b.axes[0]), glm::dot(a.axes[i], b.axes[1]),
                               glm::dot(a.axes[i], b.axes[2]), 0.0f};
        std::array<Float4, 3> columns;
        for (size_t j = 0; j < 3; ++j) columns[j] = Float4{m_rows[0][j], m_rows[1][j], m_rows[2][j], 0.0f};
        for (size_t i = 0; i < 3; ++i)
            m_absolute[i] = abs4(m_rows[i]) + float4(kParallel), columns[i] = abs4(columns[i]) + float4(kParallel);
        m_reach[0] = float4(a.half) + multiplied(columns, b.half);
        m_reach[1] = float4(b.half) + multiplied(m_absolute, a.half);
        place(a.center - b.center, 2, m_offset);
    }
    /// Computes the axes of edges.
    void addEdges() {
        const Float4 half = float4(m_b.half), half1 = __builtin_shufflevector(half, half, 1, 2, 0, 3),
                     half2 = __builtin_shufflevector(half, half, 2, 0, 1, 3);
        for (size_t i = 0; i < 3; ++i) {
            const size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            const Float4 row = m_absolute[i], row1 = __builtin_shufflevector(row, row, 1, 2, 0, 3),
                         row2 = __builtin_shufflevector(row, row, 2, 0, 1, 3);
            const Float4 sine2 = float4(1.0f) - m_rows[i] * m_rows[i];
            Float4 inverse = float4(0.0f);
            for (size_t j = 0; j < 3; ++j)
                if (sine2[j] > kMinEdgeSine2) inverse[j] = 1.0f / std::sqrt(sine2[j]);
            m_inverseSine[i] = inverse;
            m_reach[2 + i] = inverse * (m_absolute[i2] * float4(m_a.half[int(i1)]) +
                                        m_absolute[i1] * float4(m_a.half[int(i2)]) + half1 * row2 + half2 * row1);
        }
        place(m_a.center - m_b.center, kGroups, m_offset);
    }
    /// The projections of a vector on the axes.
    void place(const glm::vec3& v, size_t groups, Projections& out) const {
        const glm::vec3 inA = m_a.alongAxes(v);
        out[0] = float4(inA), out[1] = float4(m_b.alongAxes(v));
        for (size_t i = 0; 2 + i < groups; ++i) {
            const size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            out[2 + i] = m_inverseSine[i] * (m_rows[i1] * float4(inA[int(i2)]) - m_rows[i2] * float4(inA[int(i1)]));
        }
    }
    /// The axis of a group with the widest separation, at a displacement of the first box.
    Best widest(size_t from, size_t to, const Projections& offset) const {
        Best best;
        for (size_t group = from; group < to; ++group) {
            const Float4 separation = abs4(offset[group]) - m_reach[group];
            for (size_t lane = 0; lane < 3; ++lane)
                if (separation[lane] > best.separation && isAxis(group, lane))
                    best = {int(4 * group + lane), separation[lane]};
        }
        return best;
    }
    const Projections& offset() const { return m_offset; }
    /// Whether a face's normal is about one of the other box, too.
    bool isShared(int axis) const {
        float most = 0.0f;
        for (size_t i = 0; i < 3; ++i)
            most = std::max(most, axis < 4 ? m_absolute[size_t(axis)][i] : m_absolute[i][axis - 4]);
        return most > kShared;
    }
    float reachOf(int axis) const { return m_reach[size_t(axis / 4)][axis % 4]; }
    bool isAxis(size_t group, size_t lane) const { return group < 2 || m_inverseSine[group - 2][lane] > 0.0f; }
    /// The unit vector of an axis, on the side of the offset.
    glm::vec3 normal(int axis, const Projections& offset) const {
        const size_t group = size_t(axis / 4), lane = size_t(axis % 4);
        const float sign = offset[group][lane] < 0.0f ? -1.0f : 1.0f;
        if (group == 0) return m_a.axes[lane] * sign;
        if (group == 1) return m_b.axes[lane] * sign;
        return glm::cross(m_a.axes[group - 2], m_b.axes[lane]) * (m_inverseSine[group - 2][lane] * sign);
    }

private:
    const Box& m_a;
    const Box& m_b;
    std::array<Float4, 3> m_rows, m_absolute;  ///< cosines between axes: by axis of the first, lanes of the second
    std::array<Float4, 3> m_inverseSine{};     ///< 0: parallel
    Projections m_offset{}, m_reach{};
};

/// The gap between two boxes along a unit vector from the second to the first; negative: they may overlap.
float gapAlong(const glm::vec3& axis, const Box& a, const Box& b) {
    return glm::dot(axis, a.center - b.center) - glm::dot(glm::abs(a.alongAxes(axis)), a.half) -
           glm::dot(glm::abs(b.alongAxes(axis)), b.half);
}

/// Of the least overlap, or the widest gap.
AxisTest::Best chooseAxis(const AxisTest& axes, const AxisTest::Projections& offset, float preference) {
    AxisTest::Best best = axes.widest(1, 2, offset);
    if (const auto face = axes.widest(0, 1, offset); face.separation > best.separation + preference) best = face;
    if (const auto edge = axes.widest(2, AxisTest::kGroups, offset); edge.separation > best.separation + preference)
        best = edge;
    return best;
}

/// The same, unless the boxes overlap by a hair only along a normal of both, along which they move less: what slides
/// over a gap between two boxes would hit the second. displacement: of the first box in the step.
AxisTest::Best chooseAxisOfSlide(const AxisTest& axes, const AxisTest::Projections& offset,
                                 const glm::vec3& displacement, float voxel) {
    AxisTest::Best best = chooseAxis(axes, offset, kPreference * voxel);
    AxisTest::Projections drift{};
    axes.place(displacement, AxisTest::kGroups, drift);
    const auto closing = [&](int axis) {
        const size_t group = size_t(axis / 4), lane = size_t(axis % 4);
        return offset[group][lane] < 0.0f ? drift[group][lane] : -drift[group][lane];
    };
    float least = closing(best.axis) - kMinSlide * voxel;
    for (int axis = 0; axis < 8; ++axis) {
        if (axis % 4 == 3) continue;
        const float separation = std::abs(offset[size_t(axis / 4)][axis % 4]) - axes.reachOf(axis);
        if (separation > -kHair * voxel && closing(axis) < least && axes.isShared(axis))
            best = {axis, separation}, least = closing(axis);
    }
    return best;
}

/// The fraction of the step at which the boxes, together wider by `slack`, meet; above 1: they do not. drift: the
/// projections of the first box's displacement.
float timeOfMeeting(const AxisTest& axes, const AxisTest::Projections& drift, float slack) {
    float enter = 0.0f, leave = 1.0f;
    for (size_t group = 0; group < AxisTest::kGroups; ++group)
        for (size_t lane = 0; lane < 3; ++lane) {
            if (!axes.isAxis(group, lane)) continue;
            const float offset = std::abs(axes.offset()[group][lane]),
                        reach = axes.reachOf(int(4 * group + lane)) + slack;
            const float closing = axes.offset()[group][lane] < 0.0f ? drift[group][lane] : -drift[group][lane];
            if (offset > reach && closing <= 0.0f) return 2.0f;
            if (closing > 0.0f) enter = std::max(enter, (offset - reach) / closing);
            if (closing != 0.0f) leave = std::min(leave, (closing > 0.0f ? offset + reach : offset - reach) / closing);
        }
    return enter <= leave ? enter : 2.0f;
}

/// The contacts of two boxes where they meet, along an axis.
class BoxClip {
public:
    /// way: of the first box from where it is now to there. limit: separation now up to which points are contacts.
    BoxClip(const Box& a, const Box& b, const glm::vec3& way, float limit, uint64_t key, std::vector<ContactPoint>& out)
        : m_a(a), m_b(b), m_way(way), m_limit(limit), m_key(key), m_out(out) {
        m_a.center += way;
    }
    /// Appends the contacts along an axis by its number. normal: its unit vector from the second box to the first.
    void collide(int axis, const glm::vec3& normal) {
        const int group = axis / 4, lane = axis % 4;
        if (group == 0) return collideFace(true, lane, normal);
        if (group == 1) return collideFace(false, lane, normal);
        collideEdges(group - 2, lane, normal);
    }

private:
    /// A corner of the polygon: coordinates along the face and above it.
    struct Corner {
        glm::vec3 at{0.0f};
        uint32_t ofOther = kNoCode, ofFace = kNoCode;  ///< the corners or edges of the two boxes that meet there
        uint32_t edge = kNoCode;  ///< code of the edge to the next corner, if it is one of the other box
        int side = -1;            ///< of the face along which that edge lies; -1: it is one of the other box
    };

    /// The face of one box across its axis, against the other box.
    void collideFace(bool isOfFirst, int axis, const glm::vec3& normal) {
        const Box &owner = isOfFirst ? m_a : m_b, &other = isOfFirst ? m_b : m_a;
        const glm::vec3 outward = isOfFirst ? -normal : normal;
        const bool isHigh = glm::dot(outward, owner.axes[size_t(axis)]) > 0.0f;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        takeOpposedFace(other, outward);
        for (size_t i = 0; i < m_count; ++i) {
            const glm::vec3 p = owner.alongAxes(other.center - owner.center + other.toWorld(m_corners[i].at));
            m_corners[i].at = {p[u], p[v], (isHigh ? p[axis] : -p[axis]) - owner.half[axis]};
        }
        for (int side = 0; side < 4; ++side) clip(owner, axis, isHigh, side);
        for (size_t i = 0; i < m_count; ++i) {
            const Corner& corner = m_corners[i];
            glm::vec3 p(0.0f);
            p[u] = corner.at.x, p[v] = corner.at.y;
            p[axis] = (owner.half[axis] + corner.at.z) * (isHigh ? 1.0f : -1.0f);
            add(owner.center + owner.toWorld(p), normal, corner.at.z, isOfFirst,
                isOfFirst ? corner.ofFace : corner.ofOther, isOfFirst ? corner.ofOther : corner.ofFace);
        }
    }

    /// An edge of the first box along its axis i against one of the second along its axis j.
    void collideEdges(int i, int j, const glm::vec3& normal) {
        uint32_t cornerA = 0, cornerB = 0;
        const glm::vec3 middleA = edgeMiddle(m_a, i, -normal, cornerA), middleB = edgeMiddle(m_b, j, normal, cornerB);
        const glm::vec3 &alongA = m_a.axes[size_t(i)], &alongB = m_b.axes[size_t(j)], apart = middleB - middleA;
        const float cosine = glm::dot(alongA, alongB), sine2 = 1.0f - cosine * cosine;
        const float onA = glm::dot(apart, alongA), onB = glm::dot(apart, alongB);
        const glm::vec3 a = middleA + alongA * ((onA - cosine * onB) / sine2),
                        b = middleB + alongB * ((cosine * onA - onB) / sine2);
        add(a, normal, glm::dot(normal, a - b), false, edgeCode(i, cornerA), edgeCode(j, cornerB));
    }

    /// The middle of the edge along an axis that reaches the farthest in a direction, and bits of its corners.
    static glm::vec3 edgeMiddle(const Box& box, int axis, const glm::vec3& direction, uint32_t& corner) {
        glm::vec3 at = box.center;
        for (int k = 0; k < 3; ++k) {
            if (k == axis) continue;
            const bool isHigh = glm::dot(box.axes[size_t(k)], direction) > 0.0f;
            corner |= uint32_t(isHigh) << k;
            at += box.axes[size_t(k)] * (isHigh ? box.half[k] : -box.half[k]);
        }
        return at;
    }

    /// The corners of the face of a box that is the most opposed to a direction, in its axes, from its middle.
    void takeOpposedFace(const Box& box, const glm::vec3& direction) {
        const glm::vec3 along = box.alongAxes(direction), size = glm::abs(along);
        const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const uint32_t side = along[axis] < 0.0f ? 1u << axis : 0u;
        m_count = 4;
        for (uint32_t i = 0; i < 4; ++i) {
            const uint32_t corner = side | (i == 1 || i == 2 ? 1u << u : 0u) | (i >= 2 ? 1u << v : 0u);
            Corner& out = m_corners[i];
            for (int k = 0; k < 3; ++k) out.at[k] = corner >> k & 1 ? box.half[k] : -box.half[k];
            out.ofOther = corner, out.ofFace = kNoCode;
            out.edge = edgeCode(i % 2 ? v : u, corner), out.side = -1;
        }
    }

    /// Cuts off what lies beyond a side of the face across `axis`. side: 0 and 1 across the next axis, 2 and 3 across
    /// the one after; odd: on its high side.
    void clip(const Box& owner, int axis, bool isHigh, int side) {
        const int across = side / 2;
        const float sign = side & 1 ? 1.0f : -1.0f, end = owner.half[(axis + 1 + across) % 3];
        std::array<float, kMaxCorners> beyond;
        bool any = false;
        for (size_t i = 0; i < m_count; ++i)
            beyond[i] = m_corners[i].at[across] * sign - end, any = any || beyond[i] > 0.0f;
        if (!any) return;
        std::array<Corner, kMaxCorners> kept;
        size_t count = 0;
        for (size_t i = 0; i < m_count; ++i) {
            const size_t next = (i + 1) % m_count;
            const Corner &from = m_corners[i], &to = m_corners[next];
            if (beyond[i] <= 0.0f && count < kMaxCorners) kept[count++] = from;
            if ((beyond[i] <= 0.0f) == (beyond[next] <= 0.0f) || count == kMaxCorners) continue;
            Corner& crossing = kept[count++];
            crossing = from;
            crossing.at = from.at + (to.at - from.at) * (beyond[i] / (beyond[i] - beyond[next]));
            setCrossingCodes(axis, isHigh, side, crossing);
            if (beyond[i] <= 0.0f) crossing.side = side;
        }
        m_corners = kept, m_count = count;
    }

    /// Sets the codes of where the edge after a corner crosses a side of the face across `axis`.
    static void setCrossingCodes(int axis, bool isHigh, int side, Corner& corner) {
        const auto bitOf = [&](int s) { return s & 1 ? 1u << (axis + 1 + s / 2) % 3 : 0u; };
        const uint32_t bits = (isHigh ? 1u << axis : 0u) | bitOf(side);
        if (corner.side >= 0)
            corner.ofFace = bits | bitOf(corner.side), corner.ofOther = kNoCode;
        else
            corner.ofFace = edgeCode((axis + 2 - side / 2) % 3, bits), corner.ofOther = corner.edge;
    }

    /// point: of the box that does not own the face, or of the first box.
    void add(const glm::vec3& point, const glm::vec3& normal, float separation, bool isOfSecond, uint32_t codeA,
             uint32_t codeB) {
        const float apart = separation - glm::dot(normal, m_way);
        if (apart > m_limit) return;
        ContactPoint& contact = m_out.emplace_back();
        contact.position = isOfSecond ? point + normal * (0.5f * apart) : point - m_way - normal * (0.5f * apart);
        contact.normal = normal;
        contact.separation = apart;
        if (const std::pair entries(m_a.entryAt(point), m_b.entryAt(point)); entries != m_entries) {
            m_entries = entries;
            const ContactMaterials &ofA = m_a.part.contactMaterials(), &ofB = m_b.part.contactMaterials();
            m_friction = std::sqrt(ofA.friction[entries.first] * ofB.friction[entries.second]);
            m_restitution = std::sqrt(ofA.restitution[entries.first] * ofB.restitution[entries.second]);
        }
        contact.friction = m_friction, contact.restitution = m_restitution;
        contact.feature =
            m_key | uint64_t(isOfSecond) | uint64_t(kBoxKind) << 12 | uint64_t(codeA) << 17 | uint64_t(codeB) << 22;
    }

    Box m_a;
    const Box& m_b;
    glm::vec3 m_way;
    float m_limit;
    uint64_t m_key;
    std::vector<ContactPoint>& m_out;
    std::array<Corner, kMaxCorners> m_corners;
    size_t m_count = 0;
    std::pair<uint8_t, uint8_t> m_entries{0, 0};  ///< of the last point
    float m_friction = 0.0f, m_restitution = 0.0f;
};

/// How the first box moves against the second in the step.
struct BoxMotion {
    glm::vec3 slide{0.0f};         ///< of its middle, metres
    glm::vec3 displacement{0.0f};  ///< the same; 0: nothing moves far
    float turn = 0.0f;             ///< metres by which the spins of both move a point, at most; 0 likewise
    BoxMotion(const MovingPart& first, const Box& a, const MovingPart& second, const Box& b,
              const NarrowphaseSettings& settings) {
        slide = glm::vec3((first.velocityAt(glm::dvec3(a.center)) - second.velocityAt(glm::dvec3(b.center))) *
                          settings.seconds);
        const double spins = glm::length(first.spin) * a.diagonal() + glm::length(second.spin) * b.diagonal();
        const auto turned = float(spins * settings.seconds);
        if (std::sqrt(glm::dot(slide, slide)) + turned > float(settings.sweepThreshold))
            displacement = slide, turn = turned;
    }
    bool isFast() const { return displacement != glm::vec3(0.0f) || turn != 0.0f; }
    /// Metres by which they come closer, at most.
    float closing() const { return turn + std::sqrt(glm::dot(displacement, displacement)); }
    /// The same along a unit vector from the second to the first.
    float closing(const glm::vec3& axis) const { return turn + std::max(-glm::dot(displacement, axis), 0.0f); }
};

}  // namespace

bool collideBoxes(const MovingPart& first, const MovingPart& second, const NarrowphaseSettings& settings,
                  uint64_t partKey, ContactSearch& search, std::vector<ContactPoint>& out) {
    const Box a(first), b(second);
    const BoxMotion motion(first, a, second, b, settings);
    const float voxel = float(std::min(first.part.voxelSize(), second.part.voxelSize()));
    const float margin = std::min(float(settings.margin), kMaxContactMargin * voxel);
    glm::vec3& axis = search.axis;
    // Most that are apart are so along the axis of the step before. Nothing depends on whether it is tried.
    if (axis != glm::vec3(0.0f))
        if (const float gap = gapAlong(axis, a, b) - margin; gap > motion.closing() + kGapRounding) {
            search.clearance = std::min(search.clearance, gap);
            return false;
        }
    AxisTest axes(a, b);
    const auto setApart = [&](const AxisTest::Best& best) {
        search.clearance = std::min(search.clearance, best.separation - margin);
        return false;
    };
    const auto isApartAlong = [&](const AxisTest::Best& best) {
        axis = axes.normal(best.axis, axes.offset());
        return best.separation > margin + motion.closing(axis);
    };
    if (const auto face = axes.widest(0, 2, axes.offset()); isApartAlong(face)) return setApart(face);
    axes.addEdges();
    const AxisTest::Best best = chooseAxisOfSlide(axes, axes.offset(), motion.slide, voxel);
    if (isApartAlong(best)) return setApart(best);
    if (best.separation > 0.0f && motion.isFast()) {
        AxisTest::Projections drift{};
        axes.place(motion.displacement, AxisTest::kGroups, drift);
        const float time = timeOfMeeting(axes, drift, motion.turn);
        if (time > 1.0f) {
            if (best.separation > margin) return setApart(best);
        } else {
            for (size_t i = 0; i < drift.size(); ++i) drift[i] = axes.offset()[i] + drift[i] * float4(time);
            const int met = chooseAxisOfSlide(axes, drift, motion.slide, voxel).axis;
            const glm::vec3 normal = axes.normal(met, drift);
            const size_t before = out.size();
            BoxClip(a, b, motion.displacement * time, margin + motion.closing(normal), partKey, out)
                .collide(met, normal);
            if (out.size() > before || best.separation > margin) return true;
        }
    }
    BoxClip(a, b, glm::vec3(0.0f), margin + motion.closing(axis), partKey, out).collide(best.axis, axis);
    return true;
}

}  // namespace rubble
