#include "render/scene/convex_polygon.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rubble {
namespace {

/// Twice the area of a triangle: above 0 if c lies to the left of the line from a to b.
double doubleArea(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Appends the half of a hull that turns left along points in their order, without its last corner.
template <class Iterator>
void appendHalf(Iterator begin, Iterator end, std::vector<glm::dvec2>& hull) {
    const size_t first = hull.size();
    for (; begin != end; ++begin) {
        while (hull.size() >= first + 2 && doubleArea(hull[hull.size() - 2], hull.back(), *begin) <= 0.0)
            hull.pop_back();
        hull.push_back(*begin);
    }
    hull.pop_back();
}

/// Whether a side of `a` has all of `b` on its outer side, or less than `touch` of it on the inner one.
bool isSeparatedBySide(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b, double touch) {
    for (size_t i = 0; i < a.size(); ++i) {
        const glm::dvec2 from = a[i], to = a[(i + 1) % a.size()];
        const double limit = touch * glm::distance(from, to);
        if (std::all_of(b.begin(), b.end(), [&](glm::dvec2 p) { return doubleArea(from, to, p) <= limit; }))
            return true;
    }
    return false;
}

}  // namespace

ConvexPolygon ConvexPolygon::around(std::vector<glm::dvec2> points) {
    const auto isBefore = [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
    std::sort(points.begin(), points.end(), isBefore);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    ConvexPolygon hull;
    if (points.size() < 3) return hull;
    appendHalf(points.begin(), points.end(), hull.m_corners);
    appendHalf(points.rbegin(), points.rend(), hull.m_corners);
    return hull;
}

ConvexPolygon ConvexPolygon::widened(double margin) const {
    std::vector<glm::dvec2> points;
    for (const glm::dvec2 corner : m_corners)
        for (int i = 0; i < 4; ++i)
            points.push_back(corner + margin * glm::dvec2(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0));
    return around(std::move(points));
}

ConvexPolygon ConvexPolygon::clipped(glm::dvec2 low, glm::dvec2 high) const {
    ConvexPolygon part = *this;
    for (int side = 0; side < 4; ++side) {
        const int axis = side & 1;
        const auto inside = [&](glm::dvec2 p) { return side < 2 ? p[axis] - low[axis] : high[axis] - p[axis]; };
        std::vector<glm::dvec2> kept;
        for (size_t i = 0; i < part.m_corners.size(); ++i) {
            const glm::dvec2 a = part.m_corners[i], b = part.m_corners[(i + 1) % part.m_corners.size()];
            const double fromA = inside(a), fromB = inside(b);
            if (fromA >= 0.0) kept.push_back(a);
            if ((fromA >= 0.0) != (fromB >= 0.0)) kept.push_back(glm::mix(a, b, fromA / (fromA - fromB)));
        }
        part.m_corners = std::move(kept);
    }
    return part;
}

double ConvexPolygon::area() const {
    double sum = 0.0;
    for (size_t i = 2; i < m_corners.size(); ++i) sum += doubleArea(m_corners[0], m_corners[i - 1], m_corners[i]);
    return 0.5 * sum;
}

bool ConvexPolygon::overlaps(const ConvexPolygon& other, double touch) const {
    if (empty() || other.empty()) return false;
    return !isSeparatedBySide(m_corners, other.m_corners, touch) &&
           !isSeparatedBySide(other.m_corners, m_corners, touch);
}

}  // namespace rubble
