#pragma once
#include <cstddef>
#include <vector>

namespace rubble {

/// A point of the ground plane, metres, world.
struct GroundPoint {
    double x = 0.0, z = 0.0;
    friend bool operator==(const GroundPoint&, const GroundPoint&) = default;
};

/// The corners of a simple polygon in the ground plane, clockwise or not; the last is joined to the first.
using GroundPolygon = std::vector<GroundPoint>;

/// Whether a point is inside, by the even-odd rule: a ray from it along +x crosses an odd number of sides.
inline bool contains(const GroundPolygon& area, double x, double z) {
    bool inside = false;
    for (size_t i = 0, j = area.size() - 1; i < area.size(); j = i++) {
        const GroundPoint &a = area[i], &b = area[j];
        if ((a.z > z) != (b.z > z) && x < (b.x - a.x) * (z - a.z) / (b.z - a.z) + a.x) inside = !inside;
    }
    return inside;
}

}  // namespace rubble
