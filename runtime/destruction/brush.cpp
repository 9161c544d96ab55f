#include "runtime/destruction/brush.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

using Point = std::array<int64_t, 3>;

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
        out[c] = std::min(steps > 0 ? steps : kBrushNothing, c ? out[c - 1] : kBrushLimit);
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
    // |fromA|^2 - along^2 / length^2 <= r^2, without dividing: 128 bits hold the products.
    using Wide = __int128;
    return Wide(fromA2) * length2 - Wide(along) * along <= Wide(radius) * radius * length2;
}

bool inBox(const Brush& brush, const Point& point, int64_t grow) {
    for (size_t i = 0; i < 3; ++i) {
        int64_t along = 0;
        for (size_t j = 0; j < 3; ++j) along += int64_t(brush.axes[3 * i + j]) * (point[j] - brush.a[j]);
        if (std::abs(along) > (brush.b[i] + grow) * 65536) return false;
    }
    return true;
}

}  // namespace

Brush sphereBrush(glm::dvec3 center, std::array<double, 3> radii) {
    return capsuleBrush(center, center, radii);
}

Brush capsuleBrush(glm::dvec3 from, glm::dvec3 to, std::array<double, 3> radii) {
    Brush brush;
    brush.radii.fill(kBrushNothing);
    if (!isNumber(from) || !isNumber(to)) return brush;
    brush.a = quantise(from);
    brush.b = quantise(to);
    brush.kind = brush.a == brush.b ? BrushKind::Sphere : BrushKind::Capsule;
    brush.radii = quantiseRadii(radii);
    return brush;
}

Brush boxBrush(glm::dvec3 center, glm::dvec3 halfSize, glm::dquat rotation, Hardness limit) {
    Brush brush{.kind = BrushKind::Box};
    brush.radii.fill(kBrushNothing);
    const bool isTurned = !std::isnan(rotation.w + rotation.x + rotation.y + rotation.z);
    if (!isNumber(center) || !isNumber(halfSize) || !isTurned) return brush;
    brush.a = quantise(center);
    brush.b = quantise(halfSize);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = 1.0;
        axis = rotation * axis;
        for (int j = 0; j < 3; ++j) brush.axes[size_t(3 * i + j)] = int32_t(std::clamp(std::floor(axis[j] * 65536.0 + 0.5), -65536.0, 65536.0));
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
    if (radius <= kBrushNothing) return {};
    CellBox box;
    for (size_t j = 0; j < 3; ++j) {
        int64_t low = std::min(brush.a[j], brush.b[j]) - radius, high = std::max(brush.a[j], brush.b[j]) + radius;
        if (brush.kind == BrushKind::Sphere) low = brush.a[j] - radius, high = brush.a[j] + radius;
        if (brush.kind == BrushKind::Box) {
            int64_t reach = 0;
            for (size_t i = 0; i < 3; ++i) reach += std::abs(int64_t(brush.axes[3 * i + j])) * (brush.b[i] + radius);
            reach = reach / 65536 + 3;  // the rounded axes may be short of a unit
            low = brush.a[j] - reach, high = brush.a[j] + reach;
        }
        constexpr int64_t kStepsABrick = kBrushUnit * kBrickSize;
        const int64_t last = sizeInBricks[int(j)];
        box.low[int(j)] = int(std::clamp<int64_t>(low < 0 ? 0 : low / kStepsABrick, 0, last));
        box.high[int(j)] = int(std::clamp<int64_t>(high < 0 ? 0 : high / kStepsABrick + 1, 0, last));
    }
    return box;
}

BrickBits brushBits(const Brush& brush, glm::ivec3 brick, int64_t radius) {
    BrickBits bits{};
    if (radius <= kBrushNothing) return bits;
    const auto cellCenter = [&](int x, int y, int z) {
        return Point{(brick.x * 8 + x) * kBrushUnit + kBrushUnit / 2, (brick.y * 8 + y) * kBrushUnit + kBrushUnit / 2,
                     (brick.z * 8 + z) * kBrushUnit + kBrushUnit / 2};
    };
    // The cell centres lie within sqrt(3) * 3.5 cells of the brick's middle, and a convex brush that holds the eight
    // outermost ones holds them all.
    constexpr int64_t kBrickReach = 1552;
    Point middle = cellCenter(4, 4, 4);
    for (int64_t& coordinate : middle) coordinate -= kBrushUnit / 2;
    if (!brushContains(brush, middle, std::max<int64_t>(radius, 0) + kBrickReach)) return bits;
    bool isWhole = true;
    for (int corner = 0; corner < 8 && isWhole; ++corner)
        isWhole = brushContains(brush, cellCenter(corner & 1 ? 7 : 0, corner & 2 ? 7 : 0, corner & 4 ? 7 : 0), radius);
    if (isWhole) {
        bits.fill(~uint64_t(0));
        return bits;
    }
    for (int i = 0; i < kBrickVoxels; ++i) {
        const glm::ivec3 cell = voxelInBrick(i);
        if (brushContains(brush, cellCenter(cell.x, cell.y, cell.z), radius)) bits[size_t(i >> 6)] |= uint64_t(1) << (i & 63);
    }
    return bits;
}

}  // namespace rubble
