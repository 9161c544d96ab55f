#pragma once
#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#include "runtime/voxel/ray_walk.h"

namespace rubble {

/// Steps a ray through the cells of a box [0, size) (J. Amanatides and A. Woo, "A fast voxel traversal algorithm for
/// ray tracing", Eurographics 1987).
///
/// The ray crosses the plane x = k at t = (k - origin.x) / direction.x, and likewise on y and z. The walk keeps, for
/// each axis, the t of the next plane; the smallest of the three is the face that the ray leaves the cell through. The
/// paper adds an increment to that t, so errors accumulate; here each t is computed from its integer plane, and t is
/// monotone in the plane because subtraction and division round monotonically. So leave() can jump over any block of
/// cells and arrive at exactly the cell, and the t, that single steps arrive at.
///
/// Faces crossed at the same t are taken in the order x, y, z: the walk goes around corners, never through them. A
/// point on a face belongs to the cell that the ray goes into; to the higher cell if the ray runs along the face.
class CellWalk {
public:
    /// Enters the box. False if the ray misses it or holds a NaN or an infinity (tMax may be infinite).
    bool start(const CellRay& ray, glm::ivec3 size) {
        if (!scale(ray)) return false;
        m_size = size;
        glm::dvec3 enter(0.0);
        int last = -1;
        for (int a = 0; a < 3; ++a) {
            // In double: an origin may lie beyond the range of integers.
            const double begin = m_direction[a] < 0.0 ? std::ceil(m_origin[a]) - 1.0 : std::floor(m_origin[a]);
            const bool before = m_direction[a] < 0.0 ? begin >= size[a] : begin < 0.0;
            const bool beyond = m_direction[a] < 0.0 ? begin < 0.0 : begin >= size[a];
            if (beyond || (before && m_direction[a] == 0.0)) return false;
            m_cell[a] = before ? (m_direction[a] < 0.0 ? size[a] : -1) : int(begin);
            if (!before) continue;
            enter[a] = crossing(a, m_direction[a] < 0.0 ? size[a] : 0);
            if (last < 0 || enter[a] >= enter[last]) last = a;
        }
        m_axis = last;
        if (last < 0) {
            for (int a = 0; a < 3; ++a) m_next[a] = nextCrossing(a);
            return m_tMax >= 0.0;
        }
        m_t = enter[last];
        return m_t <= m_tMax && arrive(last, m_cell[last] + stepOf(last), glm::ivec3(-1), size);
    }

    /// Goes to the next cell. False if that is outside the box or beyond tMax.
    bool step() {
        const int a = earliest(m_next);
        if (!(m_next[a] <= m_tMax)) return false;
        m_t = m_next[a];
        m_axis = a;
        m_cell[a] += stepOf(a);
        m_next[a] = nextCrossing(a);
        return m_cell[a] >= 0 && m_cell[a] < m_size[a];
    }

    /// Goes to the first cell outside the block [low, high), which holds the current cell. False as for step().
    bool leave(glm::ivec3 low, glm::ivec3 high) {
        glm::dvec3 exit;
        for (int a = 0; a < 3; ++a)
            exit[a] = m_direction[a] == 0.0 ? std::numeric_limits<double>::infinity()
                                            : crossing(a, m_direction[a] < 0.0 ? low[a] : high[a]);
        const int axis = earliest(exit);
        if (!(exit[axis] <= m_tMax) || m_direction[axis] == 0.0) return false;
        m_t = exit[axis];
        m_axis = axis;
        return arrive(axis, m_direction[axis] < 0.0 ? low[axis] - 1 : high[axis], low, high);
    }

    /// The current cell.
    glm::ivec3 cell() const { return m_cell; }
    /// Where the ray enters the current cell, in multiples of its direction.
    double t() const { return m_exponent ? std::ldexp(m_t, m_exponent) : m_t; }
    /// Axis of the face that the current cell was entered through; -1 if the ray starts in it.
    int axis() const { return m_axis; }
    /// Outward normal, along axis(), of the face entered through; 0 if the ray starts in the cell.
    int sign() const { return m_axis < 0 ? 0 : -stepOf(m_axis); }

private:
    /// A direction of extreme length is scaled by a power of two: the same ray, without overflow for any length.
    bool scale(const CellRay& ray) {
        double largest = 0.0;
        for (int a = 0; a < 3; ++a) {
            if (!std::isfinite(ray.origin[a]) || !std::isfinite(ray.direction[a])) return false;
            largest = std::max(largest, std::fabs(ray.direction[a]));
        }
        if (std::isnan(ray.tMax)) return false;
        m_origin = ray.origin;
        m_direction = ray.direction;
        m_exponent = largest == 0.0 || (largest > 0x1p-200 && largest < 0x1p200) ? 0 : -std::ilogb(largest);
        if (m_exponent)
            for (int a = 0; a < 3; ++a) m_direction[a] = std::ldexp(ray.direction[a], m_exponent);
        m_tMax =
            std::min(m_exponent ? std::ldexp(ray.tMax, -m_exponent) : ray.tMax, std::numeric_limits<double>::max());
        m_t = 0.0;
        return true;
    }
    int stepOf(int axis) const { return m_direction[axis] < 0.0 ? -1 : 1; }
    /// The t of a plane. The direction along the axis is not zero.
    double crossing(int axis, int plane) const { return (plane - m_origin[axis]) / m_direction[axis]; }
    double nextCrossing(int axis) const {
        if (m_direction[axis] == 0.0) return std::numeric_limits<double>::infinity();
        return crossing(axis, m_cell[axis] + (m_direction[axis] > 0.0));
    }
    static int earliest(const glm::dvec3& t) { return t.x <= t.y ? (t.x <= t.z ? 0 : 2) : (t.y <= t.z ? 1 : 2); }

    /// The ray has just crossed into `cell` on `axis` at m_t. On the other axes, takes all crossings before that one;
    /// they lie in [low - 1, high], as the walk has not left that block on those axes.
    bool arrive(int axis, int cell, glm::ivec3 low, glm::ivec3 high) {
        m_cell[axis] = cell;
        for (int a = 0; a < 3; ++a) {
            if (a != axis && m_direction[a] != 0.0) m_cell[a] = cellAt(a, axis, low[a], high[a]);
            m_next[a] = nextCrossing(a);
        }
        for (int a = 0; a < 3; ++a)
            if (m_cell[a] < 0 || m_cell[a] >= m_size[a]) return false;
        return true;
    }
    /// The cell on axis `a` when the ray crosses into a cell on `axis` at m_t.
    int cellAt(int a, int axis, int low, int high) const {
        const bool forward = m_direction[a] > 0.0;
        const auto crossed = [&](int plane) {
            const double t = crossing(a, plane);
            return t < m_t || (t == m_t && a < axis);
        };
        // An estimate, corrected by the comparisons that step() makes.
        const double guess = std::floor(m_origin[a] + m_direction[a] * m_t);
        int c = int(std::clamp(guess, double(low), double(high - (forward ? 0 : 1))));
        c = forward ? std::max(c, m_cell[a]) : std::min(c, m_cell[a]);
        if (forward) {
            while (c < high && crossed(c + 1)) ++c;
            while (c > m_cell[a] && !crossed(c)) --c;
        } else {
            while (c >= low && crossed(c)) --c;
            while (c < m_cell[a] && !crossed(c + 1)) ++c;
        }
        return c;
    }

    glm::dvec3 m_origin{0.0}, m_direction{0.0};
    double m_tMax = 0.0, m_t = 0.0;
    int m_exponent = 0;
    glm::ivec3 m_size{0}, m_cell{0};
    glm::dvec3 m_next{0.0};  ///< by axis: the t of the next plane
    int m_axis = -1;
};

}  // namespace rubble
