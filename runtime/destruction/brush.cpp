#include "runtime/destruction/brush.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/planted_fault.h"

namespace rubble {
namespace {

using Point = std::array<int64_t, 3>;

constexpr int64_t kAxisUnit = 65536;  ///< of Brush::axes: a unit vector's length

int64_t quantise(double cells) {
    const double steps = std::floor(cells * double(kBrushUnit) + 0.5);
    return int64_t(std::clamp(steps, -double(kBrushLimit), double(kBrushLimit)));
}

Point quantise(glm::dvec3 cells) {
    return {quantise(cells.x), quantise(cells.y), quantise(cells.z)};
}

bool isNumber(glm::dvec3 v) {
    return !std::isnan(v.x) && !std::isnan(v.y) && !std::isnan(v.z);
}

std::array<int64_t, 3> quantiseRadii(std::array<double, 3> radii) {
    std::array<int64_t, 3> out{};
    for (size_t c = 0; c < 3; ++c) {
        const int64_t steps = std::isnan(radii[c]) ? 0 : quantise(radii[c]);
        out[c] = std::min(steps > 0 ? steps : kBrushEmptyRadius, c ? out[c - 1] : kBrushLimit);
    }
    return out;
}

bool inCapsule(const Brush& brush, const Point& point, int64_t radius) {
    int64_t along = 0, length2 = 0, fromA2 = 0, fromB2 = 0;
    for (size_t i = 0; i < 3; ++i) {
        const int64_t axis = brush.b[i] - brush.a[i], fromA = point[i] - brush.a[i], fromB = point[i] - brush.b[i];
        along += fromA * axis;
        length2 += axis * axis;
        fromA2 += fromA * fromA;
        fromB2 += fromB * fromB;
    }
    if (along <= 0) return fromA2 <= radius * radius;
    if (along >= length2) return fromB2 <= radius * radius;
    // |fromA|^2 - along^2 / length^2 <= r^2 without a division; the products need 128 bits.
    using Wide = __int128;
    return Wide(fromA2) * length2 - Wide(along) * along <= Wide(radius) * radius * length2;
}

bool inBox(const Brush& brush, const Point& point, int64_t grow) {
    for (size_t i = 0; i < 3; ++i) {
        int64_t along = 0;
        for (size_t j = 0; j < 3; ++j) along += int64_t(brush.axes[3 * i + j]) * (point[j] - brush.a[j]);
        if (std::abs(along) > (brush.b[i] + grow) * kAxisUnit) return false;
    }
    return true;
}

constexpr BrickBits kNoCell{};
constexpr int64_t kLast = kBrickSize - 1;

/// The cells of a brick where a linear function is in [-limit, limit]. Its value in the first cell is `first`; from
/// cell to cell it grows by `steps` along each axis.
BrickBits linearBits(int64_t first, const Point& steps, int64_t limit) {
    int64_t low = first, high = first;
    for (const int64_t step : steps) (step < 0 ? low : high) += kLast * step;
    if (low > limit || high < -limit) return kNoCell;
    if (low >= -limit && high <= limit) return kFullBrickBits;
    const auto row = [&](int64_t value) {
        uint64_t bits = 0;
        for (int x = 0; x < kBrickSize; ++x, value += steps[0]) bits |= uint64_t(std::abs(value) <= limit) << x;
        return bits;
    };
    BrickBits out{};
    if (steps[1] == 0 && steps[2] == 0) {
        out.fill(row(first) * kFirstColumn);
        return out;
    }
    for (int64_t z = 0; z < kBrickSize; ++z)
        for (int64_t y = 0; y < kBrickSize; ++y) out[size_t(z)] |= row(first + y * steps[1] + z * steps[2]) << 8 * y;
    return out;
}

BrickBits boxBits(const Brush& brush, const Point& first, int64_t grow) {
    BrickBits out = kFullBrickBits;
    for (size_t i = 0; i < 3; ++i) {
        int64_t along = 0;
        Point steps;
        for (size_t j = 0; j < 3; ++j) {
            along += int64_t(brush.axes[3 * i + j]) * (first[j] - brush.a[j]);
            steps[j] = brush.axes[3 * i + j] * kBrushUnit;
        }
        const BrickBits within = linearBits(along, steps, (brush.b[i] + grow) * kAxisUnit);
        for (size_t z = 0; z < 8; ++z) out[z] &= within[z];
        if (out == kNoCell) return out;
    }
    return out;
}

BrickBits sphereBits(const Brush& brush, const Point& first, int64_t radius) {
    std::array<std::array<int64_t, kBrickSize>, 3> squares;  // squared distance to the centre along each axis
    int64_t nearest = 0, farthest = 0;
    for (size_t j = 0; j < 3; ++j) {
        for (size_t i = 0; i < kBrickSize; ++i)
            squares[j][i] =
                (first[j] + int64_t(i) * kBrushUnit - brush.a[j]) * (first[j] + int64_t(i) * kBrushUnit - brush.a[j]);
        nearest += *std::min_element(squares[j].begin(), squares[j].end());
        farthest += std::max(squares[j].front(), squares[j].back());
    }
    if (nearest > radius * radius) return kNoCell;
    if (farthest <= radius * radius) return kFullBrickBits;
    BrickBits out{};
    for (size_t z = 0; z < kBrickSize; ++z)
        for (size_t y = 0; y < kBrickSize; ++y) {
            const int64_t left = radius * radius - squares[1][y] - squares[2][z];
            if (left < 0) continue;
            const size_t end = isPlanted("brush-off-by-one") ? kBrickSize - 1 : kBrickSize;
            for (size_t x = 0; x < end; ++x) out[z] |= uint64_t(squares[0][x] <= left) << (x + 8 * y);
        }
    return out;
}

BrickBits capsuleBits(const Brush& brush, const Point& first, int64_t radius) {
    // All cell centres lie within sqrt(3) * 3.5 cells of the brick's centre. A convex brush that holds the eight
    // outermost cell centres holds them all.
    constexpr int64_t kBrickCircumradius = 1552, kMiddle = kLast * kBrushUnit / 2;
    if (!inCapsule(brush, {first[0] + kMiddle, first[1] + kMiddle, first[2] + kMiddle}, radius + kBrickCircumradius))
        return kNoCell;
    const auto isTouched = [&](int64_t x, int64_t y, int64_t z) {
        return inCapsule(brush, {first[0] + x * kBrushUnit, first[1] + y * kBrushUnit, first[2] + z * kBrushUnit},
                         radius);
    };
    bool isWhole = true;
    for (int corner = 0; corner < 8 && isWhole; ++corner)
        isWhole = isTouched(corner & 1 ? kLast : 0, corner & 2 ? kLast : 0, corner & 4 ? kLast : 0);
    if (isWhole) return kFullBrickBits;
    BrickBits out{};
    for (int i = 0; i < kBrickVoxels; ++i) {
        const glm::ivec3 cell = voxelInBrick(i);
        if (isTouched(cell.x, cell.y, cell.z)) setVoxel(out, i);
    }
    return out;
}

}  // namespace

Brush sphereBrush(glm::dvec3 center, std::array<double, 3> radii) {
    return capsuleBrush(center, center, radii);
}

Brush capsuleBrush(glm::dvec3 from, glm::dvec3 to, std::array<double, 3> radii) {
    Brush brush;
    brush.radii.fill(kBrushEmptyRadius);
    if (!isNumber(from) || !isNumber(to)) return brush;
    brush.a = quantise(from);
    brush.b = quantise(to);
    brush.kind = brush.a == brush.b ? BrushKind::Sphere : BrushKind::Capsule;
    brush.radii = quantiseRadii(radii);
    return brush;
}

Brush boxBrush(glm::dvec3 center, glm::dvec3 halfSize, glm::dquat rotation, Hardness limit) {
    Brush brush{.kind = BrushKind::Box};
    brush.radii.fill(kBrushEmptyRadius);
    const bool isRotation = !std::isnan(rotation.w + rotation.x + rotation.y + rotation.z);
    if (!isNumber(center) || !isNumber(halfSize) || !isRotation) return brush;
    brush.a = quantise(center);
    brush.b = quantise(halfSize);
    constexpr double kUnit = double(kAxisUnit);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = 1.0;
        axis = rotation * axis;
        for (int j = 0; j < 3; ++j)
            brush.axes[size_t(3 * i + j)] = int32_t(std::clamp(std::floor(axis[j] * kUnit + 0.5), -kUnit, kUnit));
    }
    for (size_t c = 0; c < 3; ++c)
        if (c <= size_t(limit)) brush.radii[c] = 0;
    return brush;
}

bool brushContains(const Brush& brush, std::array<int64_t, 3> point, int64_t radius) {
    if (brush.kind == BrushKind::Box) return inBox(brush, point, radius);
    if (radius <= 0) return false;
    if (brush.kind == BrushKind::Capsule) return inCapsule(brush, point, radius);
    int64_t distance2 = 0;
    for (size_t i = 0; i < 3; ++i) distance2 += (point[i] - brush.a[i]) * (point[i] - brush.a[i]);
    return distance2 <= radius * radius;
}

CellBox brushBricks(const Brush& brush, glm::ivec3 sizeInBricks) {
    const int64_t radius = *std::max_element(brush.radii.begin(), brush.radii.end());
    if (radius <= kBrushEmptyRadius) return {};
    CellBox box;
    for (size_t j = 0; j < 3; ++j) {
        int64_t low = std::min(brush.a[j], brush.b[j]) - radius, high = std::max(brush.a[j], brush.b[j]) + radius;
        if (brush.kind == BrushKind::Sphere) low = brush.a[j] - radius, high = brush.a[j] + radius;
        if (brush.kind == BrushKind::Box) {
            int64_t halfExtent = 0;
            for (size_t i = 0; i < 3; ++i)
                halfExtent += std::abs(int64_t(brush.axes[3 * i + j])) * (brush.b[i] + radius);
            halfExtent = halfExtent / kAxisUnit + 3;  // rounding may have shortened the axes
            low = brush.a[j] - halfExtent, high = brush.a[j] + halfExtent;
        }
        constexpr int64_t kUnitsPerBrick = kBrushUnit * kBrickSize;
        const int64_t last = sizeInBricks[int(j)];
        box.low[int(j)] = int(std::clamp<int64_t>(low < 0 ? 0 : low / kUnitsPerBrick, 0, last));
        box.high[int(j)] = int(std::clamp<int64_t>(high < 0 ? 0 : high / kUnitsPerBrick + 1, 0, last));
    }
    return box;
}

BrickBits brushBits(const Brush& brush, glm::ivec3 brick, int64_t radius) {
    if (radius <= kBrushEmptyRadius || (radius <= 0 && brush.kind != BrushKind::Box)) return {};
    const glm::ivec3 cell = brick * kBrickSize;
    const Point first = {cell.x * kBrushUnit + kBrushUnit / 2, cell.y * kBrushUnit + kBrushUnit / 2,
                         cell.z * kBrushUnit + kBrushUnit / 2};
    if (brush.kind == BrushKind::Box) return boxBits(brush, first, radius);
    return brush.kind == BrushKind::Sphere ? sphereBits(brush, first, radius) : capsuleBits(brush, first, radius);
}

}  // namespace rubble
