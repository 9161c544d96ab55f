#pragma once
#include <glm/vec2.hpp>
#include <vector>

namespace rubble {

/// A convex polygon in a plane, of any unit: its corners counter-clockwise. Fewer than three: it is empty.
class ConvexPolygon {
public:
    /// The smallest one around points, in any order (Andrew 1979, the monotone chain).
    static ConvexPolygon around(std::vector<glm::dvec2> points);

    /// The smallest one around this one moved by up to `margin` along each axis.
    ConvexPolygon widened(double margin) const;
    /// The part of it in a rectangle (Sutherland and Hodgman 1974).
    ConvexPolygon clipped(glm::dvec2 low, glm::dvec2 high) const;
    /// In units of the plane, squared.
    double area() const;
    /// Whether both have an area in common, by the separating axis theorem: more than a strip of `touch`.
    bool overlaps(const ConvexPolygon& other, double touch) const;
    /// Whether it has no area.
    bool empty() const { return m_corners.size() < 3; }
    /// Counter-clockwise.
    const std::vector<glm::dvec2>& corners() const { return m_corners; }

private:
    std::vector<glm::dvec2> m_corners;
};

}  // namespace rubble
