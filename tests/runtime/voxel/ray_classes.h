#pragma once
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>
#include <string>

#include "runtime/core/random.h"
#include "runtime/voxel/ray_walk.h"

/// Rays of sixteen difficult classes in grids of 16^3, and the exact first hit of each: the walks in C++ and GLSL are
/// compared with it.
namespace rubble::ray_classes {

inline constexpr int kSize = 16;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A closed interval of t.
struct Interval {
    long double low, high;
    /// Whether it holds no t.
    bool empty() const { return !(low <= high); }
};
/// The intersection.
inline Interval both(Interval a, Interval b) {
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// Where a ray is inside each slab [k, k + 1] of each axis, in long double: 11 bits more than the walk has. A ray that
/// runs along a face pierces neither voxel; the walk finds the higher one.
struct Slabs {
    /// Computes all slabs.
    explicit Slabs(const CellRay& ray) {
        for (int a = 0; a < 3; ++a)
            for (int k = 0; k < kSize; ++k) {
                const long double o = ray.origin[a], d = ray.direction[a];
                Interval& slab = at[size_t(a)][size_t(k)];
                if (d == 0.0L)
                    slab = o >= k && o < k + 1 ? Interval{0.0L, HUGE_VALL} : Interval{1.0L, 0.0L};
                else
                    slab = {std::max(0.0L, std::min((k - o) / d, (k + 1 - o) / d)),
                            std::max((k - o) / d, (k + 1 - o) / d)};
            }
    }
    /// When the ray is in a cell.
    Interval cell(glm::ivec3 c) const { return both(both(at[0][size_t(c.x)], at[1][size_t(c.y)]), at[2][size_t(c.z)]); }
    std::array<std::array<Interval, kSize>, 3> at;  ///< by axis and k
};

/// The earliest t at which the ray enters a solid voxel that it pierces by `depth` voxels or more; infinite if there is
/// none.
inline long double firstPierced(const VoxelGrid& grid, const CellRay& ray, const Slabs& slabs,
                                long double depth = 1e-4L) {
    const long double length =
        std::hypot((long double)ray.direction.x, (long double)ray.direction.y, (long double)ray.direction.z);
    long double first = HUGE_VALL;
    for (int z = 0; z < kSize; ++z) {
        if (slabs.at[2][size_t(z)].empty()) continue;
        for (int y = 0; y < kSize; ++y) {
            const Interval row = both(slabs.at[2][size_t(z)], slabs.at[1][size_t(y)]);
            if (row.empty() || row.low >= first) continue;
            for (int x = 0; x < kSize; ++x) {
                const Interval in = both(row, slabs.at[0][size_t(x)]);
                if (in.empty() || in.low >= first || !grid.at({x, y, z})) continue;
                if (length == 0.0L || (std::min<long double>(in.high, ray.tMax) - in.low) * length >= depth)
                    first = in.low;
            }
        }
    }
    return first <= ray.tMax ? first : HUGE_VALL;
}

/// Solid with a probability of one in `oneIn`, and one brick empty.
inline VoxelGrid randomGrid(Random& random, int oneIn) {
    VoxelGrid grid({kSize, kSize, kSize});
    GridWriter writer(grid);
    const int emptyBrick = int(random.below(8));  // so that the walk can skip it
    for (int i = 0; i < kSize * kSize * kSize; ++i) {
        const glm::ivec3 cell(i & 15, i >> 4 & 15, i >> 8);
        const bool isEmpty = brickOfCell(cell.x) + brickOfCell(cell.y) * 2 + brickOfCell(cell.z) * 4 == emptyBrick;
        if (!random.below(uint32_t(oneIn)) && !isEmpty) writer.set(cell, 1);
    }
    return grid;
}

/// Uniform in [low, high).
inline double draw(Random& random, double low, double high) {
    return low + (high - low) * double(random.unit());
}

/// Uniform in the cube [low, high)^3.
inline glm::dvec3 drawPoint(Random& random, double low, double high) {
    glm::dvec3 p;
    for (int a = 0; a < 3; ++a) p[a] = draw(random, low, high);
    return p;
}

/// A uniformly distributed unit vector.
inline glm::dvec3 drawDirection(Random& random) {
    for (;;) {
        const glm::dvec3 d = drawPoint(random, -1.0, 1.0);
        const double square = glm::dot(d, d);
        if (square > 0.01 && square <= 1.0) return d / std::sqrt(square);
    }
}

/// A corner of a cell.
inline glm::dvec3 drawCorner(Random& random) {
    glm::dvec3 p;
    for (int a = 0; a < 3; ++a) p[a] = random.between(0, kSize);
    return p;
}

/// What is difficult about a ray.
enum class RayClass {
    AxisParallel,
    SignedZero,
    Denormal,
    ThroughCorner,
    AlongEdge,
    InFace,
    FromFace,
    FromEdge,
    FromCorner,
    InsideSolid,
    FarOrigin,
    Scaled,
    Rotated,
    ZeroLength,
    Infinite,
    NotANumber,
    kCount
};
/// By RayClass.
inline constexpr std::array<const char*, size_t(RayClass::kCount)> kClassNames = {
    "AxisParallel", "SignedZero",  "Denormal",  "ThroughCorner", "AlongEdge", "InFace",     "FromFace", "FromEdge",
    "FromCorner",   "InsideSolid", "FarOrigin", "Scaled",        "Rotated",   "ZeroLength", "Infinite", "NotANumber"};

/// The random choices of a ray.
struct RayDraw {
    int axis, other;  ///< two different axes
    double side;      ///< 1 or -1
    double small;     ///< denormal or nearly so
};

/// Moves the origin of a random ray for the classes that are about where a ray starts.
inline void setOrigin(RayClass rayClass, const RayDraw& drawn, Random& random, CellRay& ray) {
    const auto [axis, other, side, small] = drawn;
    switch (rayClass) {
        case RayClass::ThroughCorner: {
            // Along a line between two corners: planes are crossed at equal t, often exactly.
            const glm::dvec3 corner = drawCorner(random), step = drawCorner(random) - drawCorner(random);
            ray.origin = corner - step * draw(random, 0.0, 1.0);
            ray.direction = step;
            break;
        }
        case RayClass::AlongEdge:
            ray.origin = drawCorner(random), ray.origin[axis] = draw(random, -6.0, kSize + 6.0);
            ray.direction = glm::dvec3(0.0), ray.direction[axis] = side;
            break;
        case RayClass::InFace:
            ray.origin[axis] = random.between(0, kSize), ray.direction[axis] = 0.0;
            break;
        case RayClass::FromFace:
            ray.origin[axis] = random.between(0, kSize);
            break;
        case RayClass::FromEdge:
            ray.origin[axis] = random.between(0, kSize), ray.origin[other] = random.between(0, kSize);
            break;
        case RayClass::FromCorner:
            ray.origin = drawCorner(random);
            break;
        case RayClass::InsideSolid:
            ray.origin = drawPoint(random, 0.0, kSize);
            break;
        case RayClass::FarOrigin: {
            const glm::dvec3 target = drawPoint(random, 0.0, kSize);
            ray.origin = target - ray.direction * std::pow(10.0, draw(random, 2.0, 7.0));
            ray.tMax = 2e7;
            break;
        }
        default:
            break;
    }
}

/// Changes the direction or the length of a random ray for the other classes.
inline void setDirection(RayClass rayClass, const RayDraw& drawn, Random& random, CellRay& ray) {
    const auto [axis, other, side, small] = drawn;
    switch (rayClass) {
        case RayClass::AxisParallel:
            ray.direction = glm::dvec3(0.0), ray.direction[axis] = side * draw(random, 0.1, 3.0);
            break;
        case RayClass::SignedZero:
            ray.direction[axis] = side * 0.0;
            break;
        case RayClass::Denormal:
            ray.direction[axis] = side * small;
            if (random.below(2)) ray.direction[other] = -side * small * 0.3;
            if (!random.below(4)) ray.direction *= 0x1p-1040, ray.tMax = kInfinity;
            break;
        case RayClass::Scaled: {
            const double scale = std::pow(10.0, draw(random, -4.0, 4.0));
            ray.direction *= scale, ray.tMax /= scale;
            break;
        }
        case RayClass::ZeroLength:
            if (random.below(2))
                ray.tMax = 0.0;
            else
                ray.direction = glm::dvec3(0.0);
            break;
        case RayClass::Infinite:
            ray.tMax = kInfinity;
            break;
        case RayClass::NotANumber: {
            const uint32_t place = random.below(7);
            const double value = random.below(3) || place == 6 ? kNaN : side * kInfinity;
            (place < 3 ? ray.origin[int(place)] : place < 6 ? ray.direction[int(place) - 3] : ray.tMax) = value;
            break;
        }
        default:
            break;
    }
}

/// A random ray of a class.
inline CellRay drawRay(RayClass rayClass, Random& random) {
    RayDraw drawn{};
    drawn.axis = int(random.below(3));
    drawn.other = (drawn.axis + 1 + int(random.below(2))) % 3;
    drawn.side = random.below(2) ? 1.0 : -1.0;
    drawn.small = std::ldexp(1.0 + double(random.unit()), -random.between(0, 1080));
    CellRay ray{drawPoint(random, -6.0, kSize + 6.0), drawDirection(random), draw(random, 0.0, 60.0)};
    setOrigin(rayClass, drawn, random, ray);
    setDirection(rayClass, drawn, random, ray);
    return ray;
}

/// The exact numbers of a ray, for messages.
inline std::string text(const CellRay& ray) {
    std::ostringstream out;
    out << std::hexfloat << "origin " << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z << " direction "
        << ray.direction.x << ' ' << ray.direction.y << ' ' << ray.direction.z << " tMax " << ray.tMax;
    return out.str();
}

/// Whether origin and direction are finite; tMax may be infinite.
inline bool isFinite(const CellRay& ray) {
    for (int a = 0; a < 3; ++a)
        if (!std::isfinite(ray.origin[a]) || !std::isfinite(ray.direction[a])) return false;
    return !std::isnan(ray.tMax);
}

}  // namespace rubble::ray_classes
