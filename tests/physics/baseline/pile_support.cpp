#include "tests/physics/baseline/pile_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "tests/support/grids.h"

namespace rubble {
namespace {

constexpr double kNear = 0.02;      ///< metres
constexpr double kLeftOver = 0.05;  ///< fraction of the weight that may stay unbalanced: gaps of 2 cm change lever arms
constexpr int kSweeps = 2000;

using Wrench = std::array<double, 6>;  ///< force, and torque about the centre divided by the body's size

double dot(const Wrench& a, const Wrench& b) {
    double sum = 0.0;
    for (size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
    return sum;
}

/// One shape of a body.
struct Part {
    const VoxelGrid* grid;
    double size;
    Pose pose;  ///< grid corner -> world
    glm::dvec3 low, high;
    std::vector<glm::dvec3> points;  ///< along the edges of its surface's voxels, metres from the corner
    size_t body;
};

struct Settled {
    BodyHandle handle;
    bool isStatic = false, held = false;
    glm::dvec3 center{0.0};
    double radius = 1.0;
    std::vector<std::pair<size_t, Wrench>> pushes;  ///< by which other body
    std::vector<size_t> touched;
};

std::vector<glm::dvec3> edgePoints(const VoxelGrid& grid, double size) {
    std::set<std::tuple<int, int, int>> quarters;
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int v) {
            const glm::ivec3 c = position * kBrickSize + voxelInBrick(v);
            if (!isExposed(grid, c)) return;
            for (int i = 0; i < 125; ++i) {
                const glm::ivec3 at(i % 5, i / 5 % 5, i / 25);
                if ((at.x % 4 == 0) + (at.y % 4 == 0) + (at.z % 4 == 0) >= 2)
                    quarters.emplace(c.x * 4 + at.x, c.y * 4 + at.y, c.z * 4 + at.z);
            }
        });
    });
    std::vector<glm::dvec3> points;
    for (const auto& [x, y, z] : quarters) points.push_back(glm::dvec3(x, y, z) * (0.25 * size));
    return points;
}

/// The direction in which a point (in cells) is pushed out of the solid; false if it is more than `radius` cells away.
bool nearestExit(const VoxelGrid& grid, const glm::dvec3& p, double radius, glm::dvec3& out) {
    const glm::ivec3 own(glm::floor(p)), low(glm::floor(p - radius)), high(glm::floor(p + radius));
    double nearest = 1e9;
    if (grid.at(own)) {
        for (int i = 0; i < 6; ++i) {
            glm::ivec3 d(0);
            d[i / 2] = i % 2 * 2 - 1;
            if (grid.at(own + d)) continue;
            const double distance = d[i / 2] > 0 ? double(own[i / 2] + 1) - p[i / 2] : p[i / 2] - double(own[i / 2]);
            if (distance < nearest) nearest = distance, out = glm::dvec3(d);
        }
        return nearest < 1e8;
    }
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                if (!grid.at({x, y, z})) continue;
                const glm::dvec3 cell(x, y, z), d = p - glm::clamp(p, cell, cell + 1.0);
                const double distance = glm::length(d);
                if (distance < nearest) nearest = distance, out = distance > 1e-9 ? d / distance : glm::dvec3(0.0);
            }
    return nearest <= radius && out != glm::dvec3(0.0);
}

/// Adds the forces between `from`'s points and `into`, on both bodies: four about each normal, on the friction cone.
void touch(const Part& from, const Part& into, std::vector<Settled>& items) {
    Settled &a = items[from.body], &b = items[into.body];
    bool any = false;
    for (const glm::dvec3& point : from.points) {
        const glm::dvec3 at = from.pose.transformPoint(point);
        if (glm::any(glm::lessThan(at, into.low - kNear)) || glm::any(glm::greaterThan(at, into.high + kNear)))
            continue;
        glm::dvec3 normal;
        if (!nearestExit(*into.grid, into.pose.inversePoint(at) / into.size, kNear / into.size, normal)) continue;
        any = true;
        normal = into.pose.rotation * normal;
        const glm::dvec3 across = glm::normalize(std::abs(normal.x) > 0.5 ? glm::dvec3(normal.y, -normal.x, 0)
                                                                          : glm::dvec3(0, normal.z, -normal.y));
        const glm::dvec3 other = glm::cross(normal, across);
        for (const glm::dvec3& side : {across, -across, other, -other}) {
            const glm::dvec3 force = normal + side;
            const auto wrench = [&](const Settled& item, const glm::dvec3& f) {
                const glm::dvec3 torque = glm::cross(at - item.center, f) / item.radius;
                return Wrench{f.x, f.y, f.z, torque.x, torque.y, torque.z};
            };
            if (!a.isStatic) a.pushes.emplace_back(into.body, wrench(a, force));
            if (!b.isStatic) b.pushes.emplace_back(from.body, wrench(b, -force));
        }
    }
    if (!any) return;
    a.touched.push_back(into.body);
    b.touched.push_back(from.body);
}

/// Whether nonnegative multiples of the forces from supported bodies add up to the weight, by coordinate descent on the
/// squared residual.
bool balanced(const Settled& item, const std::vector<Settled>& items) {
    std::vector<const Wrench*> pushes;
    for (const auto& [by, wrench] : item.pushes)
        if (items[by].held) pushes.push_back(&wrench);
    std::vector<double> strength(pushes.size(), 0.0);
    Wrench rest{0.0, -1.0, 0.0, 0.0, 0.0, 0.0};
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (size_t i = 0; i < pushes.size(); ++i) {
            const double change = std::max(-dot(rest, *pushes[i]) / dot(*pushes[i], *pushes[i]), -strength[i]);
            strength[i] += change;
            for (size_t k = 0; k < 6; ++k) rest[k] += change * (*pushes[i])[k];
        }
        if (dot(rest, rest) < kLeftOver * kLeftOver) return true;
    }
    return false;
}

/// Keeps only bodies that a chain of supported bodies connects with something static.
void keepJoined(std::vector<Settled>& items) {
    std::vector<size_t> open;
    std::vector<bool> reached(items.size());
    for (size_t i = 0; i < items.size(); ++i)
        if (items[i].isStatic) open.push_back(i), reached[i] = true;
    while (!open.empty()) {
        const size_t i = open.back();
        open.pop_back();
        for (const size_t next : items[i].touched)
            if (items[next].held && !reached[next]) open.push_back(next), reached[next] = true;
    }
    for (size_t i = 0; i < items.size(); ++i) items[i].held = items[i].held && reached[i];
}

std::vector<Part> partsOf(const World& world, const Body& body, size_t index) {
    std::vector<Part> parts;
    for (const ShapeHandle shapeHandle : body.shapes) {
        const Shape& shape = world.shapes().at(shapeHandle);
        Part part{
            &shape.grid, shape.voxelSize, shapeToWorld(world, shapeHandle), glm::dvec3(1e30), glm::dvec3(-1e30), {},
            index};
        const glm::dvec3 size = glm::dvec3(shape.grid.size()) * part.size;
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 corner =
                part.pose.transformPoint({k & 1 ? size.x : 0, k & 2 ? size.y : 0, k & 4 ? size.z : 0});
            part.low = glm::min(part.low, corner);
            part.high = glm::max(part.high, corner);
        }
        if (!body.isStatic) part.points = edgePoints(shape.grid, part.size);
        parts.push_back(std::move(part));
    }
    return parts;
}

/// The sleeping bodies that neither static ones bear nor those of which `bears` is true.
template <class Bears>
std::vector<BodyHandle> findFloating(const World& world, Bears&& bears) {
    std::vector<Settled> items;
    std::vector<Part> parts;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        const bool isBase = body.isStatic || bears(handle, body);
        if (!isBase && !body.asleep) return;
        Settled item{.handle = handle, .isStatic = isBase, .held = true};
        if (!body.isStatic) item.center = body.pose.transformPoint(bodyMass(world, handle).center);
        for (Part& part : partsOf(world, body, items.size())) {
            item.radius = std::max(0.1, 0.25 * glm::length(part.high - part.low));
            parts.push_back(std::move(part));
        }
        items.push_back(std::move(item));
    });
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.low.x < b.low.x; });
    for (size_t i = 0; i < parts.size(); ++i)
        for (size_t k = i + 1; k < parts.size() && parts[k].low.x <= parts[i].high.x + kNear; ++k) {
            const Part &a = parts[i], &b = parts[k];
            if (a.body == b.body || (items[a.body].isStatic && items[b.body].isStatic)) continue;
            if (glm::any(glm::greaterThan(a.low, b.high + kNear)) || glm::any(glm::greaterThan(b.low, a.high + kNear)))
                continue;
            touch(a, b, items);
            touch(b, a, items);
        }
    for (bool changed = true; changed;) {  // a body on an unsupported one is unsupported too
        changed = false;
        keepJoined(items);
        for (Settled& item : items) {
            if (item.isStatic || !item.held || balanced(item, items)) continue;
            item.held = false;
            changed = true;
        }
    }
    std::vector<BodyHandle> floating;
    for (const Settled& item : items)
        if (!item.held) floating.push_back(item.handle);
    return floating;
}

}  // namespace

std::vector<BodyHandle> findUnsupported(const World& world) {
    return findFloating(world, [](BodyHandle, const Body&) { return false; });
}

std::vector<BodyHandle> findHanging(const World& world) {
    std::set<uint32_t> jointed;  // slots
    world.joints().forEach([&](JointHandle, const Joint& joint) {
        for (const JointEnd& end : joint.ends)
            if (end.shape) jointed.insert(world.shapes().at(end.shape).body.slot());
    });
    return findFloating(world, [&](BodyHandle handle, const Body& body) {
        bool isWet = false;
        world.waters().forEach(
            [&](WaterHandle, const Water& water) { isWet = isWet || water.contains(body.pose.position); });
        return !body.asleep || isWet || jointed.contains(handle.slot());
    });
}

std::vector<BodyHandle> findTouching(const World& world, glm::dvec3 low, glm::dvec3 high) {
    std::vector<BodyHandle> touching;
    const auto isNear = [&](const glm::dvec3& a, const glm::dvec3& b) {
        return !glm::any(glm::greaterThan(low - kNear, b)) && !glm::any(glm::lessThan(high + kNear, a));
    };
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.isStatic) return;
        for (const Part& part : partsOf(world, body, 0)) {
            if (!isNear(part.low, part.high)) continue;
            const auto touches = [&](const glm::dvec3& point) {
                return isNear(part.pose.transformPoint(point), part.pose.transformPoint(point));
            };
            if (std::none_of(part.points.begin(), part.points.end(), touches)) continue;
            touching.push_back(handle);
            return;
        }
    });
    return touching;
}

}  // namespace rubble
