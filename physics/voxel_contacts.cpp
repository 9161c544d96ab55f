#include "physics/voxel_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rubble {
namespace {

constexpr float kInset = 0.05f;     ///< voxels that a feature is looked up inside of its own solid: edges that line up still meet
constexpr float kOpposed = 0.1f;    ///< how far a normal may point along a side that a feature sticks out on
constexpr float kAlongEdge = 0.6f;  ///< how far a normal may point along an edge
constexpr float kSooner = 0.15f;    ///< cells by which a way out may be longer than one that a feature does not accept
constexpr int kDeepest = 4;         ///< cells below a surface that a way out is looked for
constexpr float kRounding = 1e-3f;  ///< cells by which more is looked at than should be needed
constexpr float kParallel = 0.15f;  ///< sine between edges below which they do not cross

using Cell = glm::ivec3;

/// Four floats that are worked on at once, and four truths (-1 or 0).
using Four = float __attribute__((vector_size(16)));
using FourBools = int __attribute__((vector_size(16)));
Four load(const float* from) {
    Four four;
    std::memcpy(&four, from, sizeof four);
    return four;
}
bool any(FourBools bools) {
    std::array<uint64_t, 2> words;
    std::memcpy(words.data(), &bools, sizeof bools);
    return (words[0] | words[1]) != 0;
}

/// Which cells of a grid are solid; remembers the last brick.
class Occupancy {
public:
    explicit Occupancy(const VoxelPart& part) : m_part(part), m_grid(part.grid()) {}
    /// False if no cell of a box, both ends included, is solid; large boxes are not looked at closely.
    bool mayTouch(Cell low, Cell high) {
        const Cell brick = glm::clamp(low, Cell(0), m_grid.size() - 1) >> 3;
        low = glm::max(low - brick * 8, Cell(-BrickSurroundings::kAround));
        high -= brick * 8;
        constexpr int kLast = kBrickSize + BrickSurroundings::kAround - 1;
        if (std::max({low.x, low.y, low.z}) > kLast || std::min({high.x, high.y, high.z}) < -BrickSurroundings::kAround) return false;
        if (std::max({high.x, high.y, high.z}) > kLast) return true;
        if (brick != m_nearAt) m_nearAt = brick, m_near = &m_part.surroundings(brick);
        return m_near->any(low, high);
    }
    /// False if no brick that a box of cells reaches into holds anything; large boxes are not looked at closely.
    bool mayHold(Cell low, Cell high) const {
        low = glm::max(low, Cell(0)) >> 3, high = glm::min(high, m_grid.size() - 1) >> 3;
        if (std::max({high.x - low.x, high.y - low.y, high.z - low.z}) > 3) return true;
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x)
                    if (m_grid.brickAt({x, y, z})) return true;
        return false;
    }
    bool solid(Cell c) {
        if (!m_grid.contains(c)) return false;
        const Cell brick = c >> 3;
        if (brick != m_at) m_at = brick, m_brick = m_grid.brickAt(brick);
        return m_brick && m_brick->solid(voxelIndex(c & 7));
    }

private:
    const VoxelPart& m_part;
    const VoxelGrid& m_grid;
    Cell m_at{-1}, m_nearAt{-1};
    const Brick* m_brick = nullptr;
    const BrickSurroundings* m_near = nullptr;
};

/// A face that a feature may rest on.
struct Face {
    int axis = -1;  ///< none
    float sign = 0.0f;
    float separation = 0.0f;  ///< cells
    Cell cell{0};             ///< that it belongs to
};

/// A feature of one shape in the cells of the other.
struct Probe {
    const FeatureKind* kind;
    glm::vec3 point;     ///< where it is
    glm::vec3 sides[3];  ///< unit vectors that it sticks out along
    int sideCount;
    glm::vec3 along;  ///< of an edge, unit
    float length;     ///< of an edge, cells
    bool isEdge() const { return kind->edgeAxis >= 0; }

    bool accepts(const glm::vec3& normal) const {
        for (int i = 0; i < sideCount; ++i)
            if (glm::dot(normal, sides[i]) > kOpposed) return false;
        return !isEdge() || std::abs(glm::dot(normal, along)) < kAlongEdge;
    }
    bool accepts(int axis, float sign) const {
        for (int i = 0; i < sideCount; ++i)
            if (sides[i][axis] * sign > kOpposed) return false;
        return !isEdge() || std::abs(along[axis]) < kAlongEdge;
    }
};

/// Rounds down; without SSE 4.1, std::floor is a call.
int floorOf(float v) {
    const int i = int(v);
    return i - (float(i) > v);
}
Cell cellOf(const glm::vec3& p) {
    return {floorOf(p.x), floorOf(p.y), floorOf(p.z)};
}

/// How far a point is from the side of its cell.
float toSide(Cell cell, const glm::vec3& p, int axis, int sign) {
    return sign > 0 ? float(cell[axis] + 1) - p[axis] : p[axis] - float(cell[axis]);
}

/// A point in a notch: its cell has no exposed face, but a cell over an edge or a corner is empty. Of the planes that meet
/// there it is behind all: the one that it is deepest behind, of the closest such cell.
Face wayOutOfNotch(Occupancy& occupancy, Cell cell, const glm::vec3& p, const Probe& probe) {
    Face best;
    float closest = 1e9f;
    for (int i = 0; i < 27; ++i) {
        const Cell d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (d.x * d.x + d.y * d.y + d.z * d.z < 2) continue;
        float distance = 0.0f, deepest = -1.0f;
        int axis = -1;
        for (int k = 0; k < 3; ++k) {
            if (!d[k]) continue;
            const float way = toSide(cell, p, k, d[k]);
            distance += way * way;
            if (way > deepest && probe.accepts(k, float(d[k]))) deepest = way, axis = k;
        }
        if (axis < 0 || distance >= closest || occupancy.solid(cell + d)) continue;
        closest = distance;
        best = {axis, float(d[axis]), -deepest, cell};
    }
    return best;
}

/// The face through which a point inside the solid gets out the soonest: of its own cell, else of a notch that it is in,
/// else straight on. None if it would get out much sooner through a face that the feature does not stick out against: then
/// another feature is in the way.
Face wayOut(Occupancy& occupancy, Cell cell, const glm::vec3& p, const Probe& probe) {
    Face best;
    best.separation = -1e9f;
    float soonest = -1e9f;  // of all faces, whatever the feature accepts
    for (int crossed = 0; crossed < kDeepest; ++crossed) {
        for (int axis = 0; axis < 3; ++axis)
            for (const int sign : {-1, 1}) {
                const float separation = -toSide(cell, p, axis, sign) - float(crossed);
                if (separation <= best.separation) continue;
                Cell owner = cell;
                owner[axis] += sign * crossed;
                Cell next = owner;
                next[axis] += sign;
                if (occupancy.solid(next)) continue;
                soonest = std::max(soonest, separation);
                if (probe.accepts(axis, float(sign))) best = {axis, float(sign), separation, owner};
            }
        if (soonest > best.separation + kSooner) return {};
        if (best.axis < 0 && crossed == 0) best = wayOutOfNotch(occupancy, cell, p, probe);
        if (best.axis >= 0) return best;
        best.separation = -1e9f;
    }
    return best;
}

/// The closest face within the margin of a point outside the solid.
Face closestFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, float margin, const Probe& probe) {
    Face best;
    best.separation = margin;
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            const float away = sign > 0 ? p[axis] - float(cell[axis]) : float(cell[axis] + 1) - p[axis];
            if (away >= best.separation || !probe.accepts(axis, float(sign))) continue;
            Cell below = cell;
            below[axis] -= sign;
            if (occupancy.solid(below)) best = {axis, float(sign), away, below};
        }
    return best;
}

/// Amanatides and Woo's walk through the cells on a way: `next` is where, in shares of the way, it leaves the cell by each axis.
struct CellSteps {
    Cell cell, step;
    glm::vec3 next, delta;

    CellSteps(Cell from, const glm::vec3& p, const glm::vec3& way) : cell(from) {
        for (int axis = 0; axis < 3; ++axis) {
            step[axis] = way[axis] > 0 ? 1 : -1;
            delta[axis] = way[axis] != 0.0f ? std::abs(1.0f / way[axis]) : 1e30f;
            next[axis] = way[axis] != 0.0f ? toSide(cell, p, axis, step[axis]) * delta[axis] : 1e30f;
        }
    }
    int axis() const { return next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2); }
    void cross(int side) {
        cell[side] += step[side];
        next[side] += delta[side];
    }
};

/// The first face that a point meets on its way.
Face firstFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, const glm::vec3& way, const Probe& probe) {
    for (CellSteps walk(cell, p, way);;) {
        const int axis = walk.axis();
        if (!(walk.next[axis] <= 1.0f)) return {};
        walk.cross(axis);
        if (!occupancy.solid(walk.cell)) continue;
        const float sign = float(-walk.step[axis]);
        if (!probe.accepts(axis, sign)) return {};
        const float plane = float(sign > 0 ? walk.cell[axis] + 1 : walk.cell[axis]);
        return {axis, sign, (p[axis] - plane) * sign, walk.cell};
    }
}

/// The stretch of an edge that is in the solid, in shares of its length from its middle. False: it is outside, or inside as
/// a whole.
bool findStretch(Occupancy& occupancy, const Probe& probe, float& from, float& to) {
    const glm::vec3 way = probe.along * probe.length, start = probe.point - way * 0.5f;
    CellSteps walk(cellOf(start), start, way);
    bool inside = occupancy.solid(walk.cell), any = inside, all = inside;
    from = 0.0f, to = 1.0f;
    for (;;) {
        const int axis = walk.axis();
        const float t = walk.next[axis];
        if (!(t < 1.0f)) break;
        walk.cross(axis);
        const bool now = occupancy.solid(walk.cell);
        all = all && now;
        if (now == inside) continue;
        if (now && !any) from = t;
        if (!now) {
            to = t;
            break;  // the first stretch is enough
        }
        inside = any = true;
    }
    from -= 0.5f, to -= 0.5f;
    return any && !all;
}

/// One shape's features against another's occupancy.
class Prober {
public:
    Prober(const VoxelPart& from, const Lattice& fromLattice, const VoxelPart& into, const Lattice& intoLattice)
        : m_from(from), m_into(into), m_occupancy(into), m_intoLattice(intoLattice), m_margin(0) {
        const double size = into.voxelSize();
        const glm::dmat3 toInto = glm::transpose(intoLattice.axes) / (size * size);
        m_axes = glm::mat3(toInto * fromLattice.axes);
        m_corner = glm::vec3(toInto * (fromLattice.corner - intoLattice.corner));
        m_scale = float(from.voxelSize() / size);
        for (int i = 0; i < 3; ++i) m_unit[i] = m_axes[i] / m_scale;
    }

    /// velocity (at the first body's frame origin) and spin of `from` against `into`, world axes. way: the longest that a
    /// feature moves in the step, metres.
    void setMotion(glm::dvec3 velocity, glm::dvec3 spin, const NarrowphaseSettings& settings, double way) {
        const double size = m_into.voxelSize();
        m_margin = std::min(float(settings.margin / size), 0.4f);
        m_sweeps = settings.continuous && way > settings.margin;
        m_reach = m_margin + (m_sweeps ? float(way / size) : 0.0f);
        if (!m_sweeps) return;
        const glm::dmat3 toInto = glm::transpose(m_intoLattice.axes) / (size * size);
        m_velocity = glm::vec3(toInto * velocity) * float(settings.seconds);
        m_spin = glm::vec3(glm::transpose(m_intoLattice.axes) * spin / size) * float(settings.seconds);
        m_about = glm::vec3(toInto * -m_intoLattice.corner);
    }

    /// False if nothing of the two is near.
    bool run(bool isFirst, uint64_t partKey, std::vector<ContactPoint>& out) {
        m_isFirst = isFirst;
        m_key = partKey;
        m_low = glm::vec3(m_into.bounds().low) - m_reach;
        m_high = glm::vec3(m_into.bounds().high) + m_reach;
        CellBox near;
        if (!overlap(near)) return false;
        placeReaches();
        if (!mayReach(near.low, near.high)) return false;
        const Cell low = near.low >> 3, high = (near.high - 1) >> 3;
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) {
                    const Cell brick(x, y, z), corner = brick * kBrickSize;
                    if (m_from.grid().brickAt(brick) && mayReach(glm::max(near.low - 1, corner), glm::min(near.high + 1, corner + kBrickSize)))
                        probeBrick(brick, near, out);
                }
        return true;
    }

private:
    /// Whether the cells [low, high) of `from` may come within reach of bricks of `into`.
    bool mayReach(Cell low, Cell high) const {
        const glm::vec3 c = m_corner + m_axes * (glm::vec3(low + high) * 0.5f), h = glm::vec3(high - low) * 0.5f;
        const glm::vec3 r =
            glm::abs(m_axes[0]) * h.x + glm::abs(m_axes[1]) * h.y + glm::abs(m_axes[2]) * h.z + (m_reach + kInset * 2.0f * m_scale + kRounding);
        return m_occupancy.mayHold(cellOf(c - r), cellOf(c + r));
    }

    /// The cells of `from` that may come within reach of `into`; false: none.
    bool overlap(CellBox& near) const {
        const glm::mat3 back = glm::transpose(m_axes) / (m_scale * m_scale);
        const glm::vec3 center = back * ((m_low + m_high) * 0.5f - m_corner), half = (m_high - m_low) * 0.5f;
        const glm::vec3 reach = glm::abs(back[0]) * half.x + glm::abs(back[1]) * half.y + glm::abs(back[2]) * half.z;
        const CellBox& own = m_from.bounds();
        const glm::vec3 low = glm::max(glm::floor(center - reach), glm::vec3(own.low)),
                        high = glm::min(glm::ceil(center + reach), glm::vec3(own.high));
        if (!glm::all(glm::lessThan(low, high))) return false;
        near = {Cell(low), Cell(high)};
        // The same the other way round: bounds that turn against each other overlap more often than what they hold.
        const glm::vec3 c = m_corner + m_axes * (glm::vec3(near.low + near.high) * 0.5f), h = glm::vec3(near.high - near.low) * 0.5f;
        const glm::vec3 r = glm::abs(m_axes[0]) * h.x + glm::abs(m_axes[1]) * h.y + glm::abs(m_axes[2]) * h.z;
        return glm::all(glm::lessThan(c - r, m_high)) && glm::all(glm::greaterThan(c + r, m_low));
    }

    /// How far around a corner, and around the middles of edges along each axis, something is looked for.
    void placeReaches() {
        m_placed = 0;
        const glm::vec3 inset = (glm::abs(m_axes[0]) + glm::abs(m_axes[1]) + glm::abs(m_axes[2])) * kInset;
        const glm::vec3 around = inset + (m_margin + kInset * m_scale + kRounding);
        m_reaches[0] = around;
        for (int axis = 0; axis < 3; ++axis) m_reaches[size_t(axis + 1)] = glm::max(around, glm::abs(m_axes[axis]) * 0.5f + kRounding);
        m_farthest = glm::max(glm::max(m_reaches[0], m_reaches[1]), glm::max(m_reaches[2], m_reaches[3]));
        if (!m_sweeps) return;
        for (glm::vec3& reach : m_reaches) reach += (std::abs(m_spin.x) + std::abs(m_spin.y) + std::abs(m_spin.z)) * glm::length(inset);
    }

    const Probe& probeOf(uint8_t kind, const glm::vec3& point) {
        Probe& probe = m_probes[kind];
        probe.point = point;
        if (m_placed >> kind & 1) return probe;
        m_placed |= 1u << kind;
        const FeatureKind& k = featureKinds()[kind];
        probe.kind = &k;
        probe.sideCount = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (k.outward[axis] != 0.0f) probe.sides[probe.sideCount++] = m_unit[axis] * k.outward[axis];
        probe.along = k.edgeAxis >= 0 ? m_unit[k.edgeAxis] : glm::vec3(0.0f);
        probe.length = m_scale;
        m_insets[kind] = m_axes * (k.outward * -kInset);
        return probe;
    }

    /// False if nothing that a feature there could meet is solid.
    bool mayMeet(const glm::vec3& point, uint8_t kind) {
        const glm::vec3& reach = m_reaches[kind < 8 ? 0 : size_t(kind - 4) / 4];
        glm::vec3 low = point - reach, high = point + reach;
        if (m_sweeps) {
            const glm::vec3 way = m_velocity + glm::cross(m_spin, point - m_about);
            low += glm::min(way, 0.0f), high += glm::max(way, 0.0f);
        }
        return m_occupancy.mayTouch(cellOf(low), cellOf(high));
    }

    /// The same of four at once, as a whole.
    bool mayMeet(const Four (&p)[3], FourBools which) {
        if (m_sweeps) return true;
        glm::vec3 low(1e9f), high(-1e9f);
        for (size_t k = 0; k < 4; ++k)
            if (which[k])
                for (int axis = 0; axis < 3; ++axis) low[axis] = std::min(low[axis], p[axis][k]), high[axis] = std::max(high[axis], p[axis][k]);
        return m_occupancy.mayTouch(cellOf(low - m_farthest), cellOf(high + m_farthest));
    }

    void probeBrick(Cell brick, const CellBox& near, std::vector<ContactPoint>& out) {
        const FeatureList& features = m_from.features(brick);
        const Cell corner = brick * kBrickSize;
        const glm::vec3 base = m_corner + m_axes * glm::vec3(corner);
        const auto four = [](float value) { return Four{value, value, value, value}; };
        Four origin[3], axes[3][3], from[3], to[3];  // what the loop reads, in registers
        for (int axis = 0; axis < 3; ++axis) {
            origin[axis] = four(base[axis]), from[axis] = four(m_low[axis]), to[axis] = four(m_high[axis]);
            for (int k = 0; k < 3; ++k) axes[k][axis] = four(m_axes[k][axis]);
        }
        const int first = std::max(near.low.z - corner.z - 1, 0), last = std::min(near.high.z - corner.z + 1, kBrickSize);
        const size_t end = features.layers[size_t(last)];
        for (size_t i = features.layers[size_t(first)] & ~size_t(3); i < end; i += 4) {
            const Four x = load(&features.x[i]), y = load(&features.y[i]), z = load(&features.z[i]);
            Four p[3];
            FourBools inside = {-1, -1, -1, -1};
            for (int axis = 0; axis < 3; ++axis) {
                p[axis] = origin[axis] + axes[0][axis] * x + axes[1][axis] * y + axes[2][axis] * z;
                inside &= (p[axis] > from[axis]) & (p[axis] < to[axis]);
            }
            if (!any(inside) || !mayMeet(p, inside)) continue;
            for (size_t k = 0; k < 4; ++k) {
                if (!inside[k]) continue;
                const uint8_t kind = features.kind[i + k];
                const glm::vec3 point(p[0][k], p[1][k], p[2][k]);
                if (mayMeet(point, kind)) test(probeOf(kind, point), kind, corner + voxelInBrick(features.voxel[i + k]), out);
            }
        }
    }

    void test(const Probe& probe, uint8_t kind, Cell own, std::vector<ContactPoint>& out) {
        if (probe.isEdge()) {
            float from, to;
            if (findStretch(m_occupancy, probe, from, to) && testCrossing(probe, from, to, kind, own, out)) return;
        }
        const glm::vec3 inset = probe.point + m_insets[kind];
        const Cell cell = cellOf(inset);
        Face face = m_occupancy.solid(cell) ? wayOut(m_occupancy, cell, inset, probe)
                                            : closestFace(m_occupancy, cell, inset, m_margin + kInset * m_scale, probe);
        if (face.axis < 0) {
            if (!m_sweeps) return;
            const glm::vec3 way = m_velocity + glm::cross(m_spin, inset - m_about);
            if (glm::dot(way, way) > m_margin * m_margin) face = firstFace(m_occupancy, cell, inset, way, probe);
            if (face.axis < 0) return;
        }
        float extra = 0.0f;  // by which the feature itself is farther in than where it was looked up
        for (int i = 0; i < probe.sideCount; ++i) extra += std::max(0.0f, -probe.sides[i][face.axis] * face.sign);
        glm::vec3 normal(0.0f);
        normal[face.axis] = face.sign;
        add(probe.point, normal, face.separation - extra * kInset * m_scale, kind, own, face.cell, out);
    }

    /// An edge that goes in and out of the solid crosses an edge of it, if there is one that is exposed and out over it is the
    /// shortest way: false if not.
    bool testCrossing(const Probe& probe, float from, float to, uint8_t kind, Cell own, std::vector<ContactPoint>& out) {
        const glm::vec3 q = probe.point + probe.along * ((from + to) * 0.5f * probe.length);
        const glm::vec3 halfStretch = glm::abs(probe.along * ((to - from) * 0.5f * probe.length));
        const Cell cell = cellOf(q);
        if (!m_occupancy.solid(cell)) return false;  // an edge that lies in a surface goes in and out by rounding
        // The two exposed faces of q's cell that are closest, if they share an edge that is exposed too.
        Cell signs(0);
        glm::vec3 depth(2.0f);
        for (int axis = 0; axis < 3; ++axis)
            for (const int sign : {-1, 1}) {
                Cell next = cell;
                next[axis] += sign;
                const float d = toSide(cell, q, axis, sign);
                if (d < depth[axis] && !m_occupancy.solid(next)) depth[axis] = d, signs[axis] = sign;
            }
        const int w = depth.x > depth.y ? (depth.x > depth.z ? 0 : 2) : (depth.y > depth.z ? 1 : 2), u = (w + 1) % 3, v = (w + 2) % 3;
        if (!signs[u] || !signs[v]) return false;
        Cell diagonal = cell;
        diagonal[u] += signs[u];
        diagonal[v] += signs[v];
        glm::vec3 edge(0.0f);
        edge[w] = 1.0f;
        glm::vec3 normal = glm::cross(probe.along, edge);
        const float length = glm::length(normal);
        if (length < kParallel || m_occupancy.solid(diagonal)) return false;
        normal /= length;
        float alongU = normal[u] * float(signs[u]), alongV = normal[v] * float(signs[v]);
        if (alongU + alongV < 0) normal = -normal, alongU = -alongU, alongV = -alongV;
        if (alongU < -kOpposed || alongV < -kOpposed || !probe.accepts(normal)) return false;
        // Out over a face is shorter if no end of the stretch is deep behind it.
        if (depth[u] * alongU + depth[v] * alongV > std::min(depth[u] + halfStretch[u], depth[v] + halfStretch[v])) return false;
        add(q, normal, -(depth[u] * alongU + depth[v] * alongV), kind, own, cell, out);
        return true;
    }

    void add(const glm::vec3& point, const glm::vec3& normal, float separation, uint8_t kind, Cell own, Cell other, std::vector<ContactPoint>& out) {
        ContactPoint contact;
        const float size = float(m_into.voxelSize());
        const glm::vec3 middle = point - normal * (separation * 0.5f);
        contact.position = glm::vec3(m_intoLattice.axes * glm::dvec3(middle) + m_intoLattice.corner);
        contact.normal = glm::vec3(m_intoLattice.axes * glm::dvec3(normal)) / (m_isFirst ? size : -size);
        contact.separation = separation * size;
        const uint8_t a = m_from.grid().at(own), b = m_into.grid().at(other);
        contact.friction = std::sqrt(m_from.surfaces().friction[a] * m_into.surfaces().friction[b]);
        contact.restitution = std::sqrt(m_from.surfaces().restitution[a] * m_into.surfaces().restitution[b]);
        contact.feature =
            m_key | uint64_t(uint32_t(own.x)) << 41 | uint64_t(uint32_t(own.y)) << 29 | uint64_t(uint32_t(own.z)) << 17 | uint64_t(kind) << 12;
        out.push_back(contact);
    }

    const VoxelPart& m_from;
    const VoxelPart& m_into;
    Occupancy m_occupancy;
    Lattice m_intoLattice;
    glm::mat3 m_axes;    ///< of a cell of `from`, in cells of `into`
    glm::vec3 m_corner;  ///< of `from`, in cells of `into`
    float m_scale;       ///< cells of `into` that a cell of `from` is long
    std::array<glm::vec3, 3> m_unit;
    uint32_t m_placed = 0;               ///< kinds whose probes are ready
    glm::vec3 m_farthest{0.0f};          ///< of the reaches
    std::array<glm::vec3, 4> m_reaches;  ///< of corners and of edges along x, y, z
    std::array<Probe, kFeatureKinds> m_probes;
    std::array<glm::vec3, kFeatureKinds> m_insets;
    float m_margin, m_reach = 0.0f;
    bool m_sweeps = false, m_isFirst = true;
    uint64_t m_key = 0;
    glm::vec3 m_velocity{0.0f}, m_spin{0.0f}, m_about{0.0f};
    glm::vec3 m_low, m_high;  ///< where features may meet `into`, in its cells
};

}  // namespace

void findContacts(const VoxelCollider& first, const Motion& firstMotion, const VoxelCollider& second, const Motion& secondMotion,
                  const NarrowphaseSettings& settings, std::vector<ContactPoint>& out) {
    const glm::dvec3 origin = firstMotion.pose.position, apart = secondMotion.pose.position - origin;
    // Relative velocity of the first at its own origin, and spin: v1 + w1 x r - (v2 + w2 x (r - apart)).
    const glm::dvec3 velocity = firstMotion.velocity - secondMotion.velocity + glm::cross(secondMotion.angularVelocity, apart);
    const glm::dvec3 spin = firstMotion.angularVelocity - secondMotion.angularVelocity;
    const double way = (glm::length(firstMotion.velocity - secondMotion.velocity) + glm::length(firstMotion.angularVelocity) * firstMotion.radius +
                        glm::length(secondMotion.angularVelocity) * secondMotion.radius) *
                       settings.seconds;
    for (size_t i = 0; i < first.parts.size(); ++i)
        for (size_t j = 0; j < second.parts.size(); ++j) {
            const VoxelPart &a = *first.parts[i], &b = *second.parts[j];
            if (a.grid().empty() || b.grid().empty()) continue;
            const Lattice& la = firstMotion.lattices[i];
            const Lattice lb{secondMotion.lattices[j].axes, secondMotion.lattices[j].corner + apart};
            const uint64_t key = uint64_t(i & 31) << 6 | uint64_t(j & 31) << 1;
            Prober forward(a, la, b, lb);
            forward.setMotion(velocity, spin, settings, way);
            if (!forward.run(true, key, out)) continue;
            Prober backward(b, lb, a, la);
            backward.setMotion(-velocity, -spin, settings, way);
            backward.run(false, key | 1, out);
        }
}

}  // namespace rubble
