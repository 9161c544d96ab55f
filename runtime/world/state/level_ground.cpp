#include "runtime/world/state/level_ground.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace rubble {
namespace {

constexpr double kMaxReach = 4096.0;  ///< metres: farther out, floats of physics get coarse

/// From low to high along one axis. The slab's cubes may not fit in evenly: then it goes beyond one of the ends.
struct Span {
    double low, high;
    bool endsAtHigh = false;  ///< goes beyond `low` instead
};

void add(const Span& x, const Span& z, double top, double side, GroundSlabs& out) {
    if (!(x.low < x.high && z.low < z.high)) return;
    const auto cubes = [&](const Span& span) { return int(std::ceil((span.high - span.low) / side)); };
    const auto low = [&](const Span& span) { return span.endsAtHigh ? span.high - cubes(span) * side : span.low; };
    out.push_back({{low(x), top - side, low(z)}, side, {cubes(x), cubes(z)}});
}

}  // namespace

GroundSlabs groundSlabs(const WorldState& world) {
    const WorldBox bounds = world.boundsInUse(), &level = world.footprint;
    if (world.settings.bounds.rule != BoundsRule::Ground || bounds.low == bounds.high) return {};
    const bool hasLevel = level.low != level.high;
    const glm::dvec3 middle = hasLevel ? 0.5 * (level.low + level.high) : 0.5 * (bounds.low + bounds.high);
    const glm::dvec3 low = glm::max(bounds.low, middle - kMaxReach), high = glm::min(bounds.high, middle + kMaxReach);
    if (!(low.x < high.x && low.z < high.z && bounds.low.y < kFieldsHeight)) return {};
    const double depth = hasLevel ? kFieldsHeight - level.low.y : 0.0;
    // As thick as the level is deep, so that nothing slips in below it.
    const double side = std::max({1.0, depth, (high.x - low.x) / kMaxGroundCubes, (high.z - low.z) / kMaxGroundCubes});
    GroundSlabs out;
    if (depth <= 0.0) {
        add({low.x, high.x}, {low.z, high.z}, kFieldsHeight, side, out);
        return out;
    }
    const Span across{std::max(low.x, level.low.x), std::min(high.x, level.high.x)};
    add({low.x, std::min(high.x, level.low.x), true}, {low.z, high.z}, kFieldsHeight, side, out);
    add({std::max(low.x, level.high.x), high.x}, {low.z, high.z}, kFieldsHeight, side, out);
    add(across, {low.z, std::min(high.z, level.low.z), true}, kFieldsHeight, side, out);
    add(across, {std::max(low.z, level.high.z), high.z}, kFieldsHeight, side, out);
    add(across, {std::max(low.z, level.low.z), std::min(high.z, level.high.z)}, level.low.y, side, out);
    return out;
}

}  // namespace rubble
