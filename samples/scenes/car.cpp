#include "samples/scenes/car.h"

#include <algorithm>

#include "samples/scenes/placement.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

struct CarSwatches {
    CarSwatches(Canvas& c, const SurfaceStyle& style)
        : paint(c.addSurface(style)),
          seam(c.addSurface(style, 72)),
          black(c.addSurface(kPlasticBlack)),
          tyre(c.addSurface(kTyre)),
          steel(c.addSurface(kSteel)),
          iron(c.addSurface(kDarkSteel)),
          glass(c.addSurface(kGlass)),
          seat(c.addSurface(kClothCream, 80)),
          head(c.addSurface(kHeadlight)),
          tail(c.addSurface(kTaillight)),
          plate(c.addSurface(kLaneWhite)),
          rust(c.addSurface(kRust)) {}
    Swatch paint, seam, black, tyre, steel, iron, glass, seat, head, tail, plate, rust;
};

void drawArches(Canvas& c, std::initializer_list<int> axles, int width) {
    for (int x : axles)
        for (int z : {0, width - 3})
            c.fill({x - 5, 1, z}, {x + 5, 9, z + 3}, [&](ivec3 cell) {
                const int dx = 2 * cell.x + 1 - 2 * x, dy = 2 * cell.y + 1 - 8;
                return dx * dx + dy * dy <= 86 ? uint8_t(0) : c.at(cell);
            });
}

/// Wheels that do not turn; an axle connects them to the floor.
void drawWheels(Canvas& c, const CarSwatches& s, std::initializer_list<int> axles, int width) {
    drawArches(c, axles, width);
    for (int x : axles)
        for (int z : {0, width - 3}) {
            c.ring(2, z, z + 3, {2 * x, 8, 0}, 4, 8, s.tyre);
            c.ring(2, z, z + 3, {2 * x, 8, 0}, -1, 4, s.steel);
        }
    for (int x : axles) c.box({x - 1, 3, 2}, {x + 1, 5, width - 2}, s.iron);
}

/// A cabin with sloping screens: cells x0..x1 at its foot, shorter by lean / 4 cells per layer in front and behind.
void drawCabin(Canvas& c, const CarSwatches& s, int low, int top, int x0, int x1, int leanBack, int leanFront,
               int width) {
    for (int y = low; y <= top; ++y) {
        const int back = x0 + (y - low) * leanBack / 4, front = x1 - (y - low) * leanFront / 4;
        const int inset = y > low ? 1 : 0;
        for (int x = back; x < front; ++x)
            for (int z = inset; z < width - inset; ++z) {
                const bool side = z == inset || z == width - inset - 1, end = x <= back + 1 || x >= front - 2;
                if (y == top) {
                    c.set({x, y, z}, s.paint);
                } else if (side || end) {
                    const bool pillar =
                        (side && (end || (x >= (x0 + x1) / 2 - 1 && x < (x0 + x1) / 2 + 1))) || y == low;
                    c.set({x, y, z}, pillar ? s.paint : s.glass);
                } else {
                    c.setEntry({x, y, z}, 0);
                }
            }
    }
}

/// A ram: bars in front of the grille on a frame that reaches to the rear axle.
void drawRam(Canvas& c) {
    const Swatch ram = c.addSurface(kRam);
    const int front = c.size().x, width = c.size().z;
    for (int y : {2, 5, 8}) c.box({front - 2, y, 1}, {front, y + 1, width - 1}, ram);
    for (int z : {3, width / 2 - 1, width - 5}) c.box({front - 2, 2, z}, {front, 9, z + 2}, ram);
    for (int z : {3, width - 5}) c.box({6, 3, z}, {front - 2, 5, z + 2}, ram);
}

void drawSeats(Canvas& c, const CarSwatches& s, std::initializer_list<int> rows, int width) {
    for (int x : rows)
        for (int z : {3, width - 8}) {
            c.box({x, 3, z}, {x + 5, 6, z + 5}, s.seat);
            c.box({x, 6, z}, {x + 1, 11, z + 5}, s.seat);
        }
}

constexpr int kLength = 42, kWidth = 18, kRearAxle = 8, kFrontAxle = 33;  // of the saloon, cells

LevelShape makeSaloon(std::string name, const SurfaceStyle& paint, bool hasWheels) {
    Canvas c({kLength, 15, kWidth});
    const CarSwatches s(c, paint);
    c.box({1, 2, 0}, {kLength - 1, 9, kWidth}, s.paint);
    c.box({0, 3, 1}, {kLength, 8, kWidth - 1}, s.paint);
    c.box({0, 2, 1}, {1, 4, kWidth - 1}, s.black);
    c.box({kLength - 1, 2, 1}, {kLength, 4, kWidth - 1}, s.black);
    c.box({1, 2, 0}, {kLength - 1, 3, kWidth}, s.black);
    c.clear({3, 3, 1}, {kLength - 3, 8, kWidth - 1});
    c.clear({11, 8, 1}, {31, 9, kWidth - 1});
    c.box({33, 3, 5}, {kLength - 4, 7, kWidth - 5}, s.iron);  // engine
    c.box({31, 3, 1}, {32, 9, kWidth - 1}, s.black);          // bulkhead
    drawCabin(c, s, 9, 14, 9, 34, 3, 7, kWidth);
    drawSeats(c, s, {13, 21}, kWidth);
    c.box({29, 6, 1}, {31, 8, kWidth - 1}, s.black);  // dashboard
    c.box({28, 8, 4}, {29, 10, 8}, s.black);          // wheel
    c.box({28, 7, 5}, {29, 8, 7}, s.black);
    if (hasWheels) {
        drawWheels(c, s, {kRearAxle, kFrontAxle}, kWidth);
    } else {
        drawArches(c, {kRearAxle, kFrontAxle}, kWidth);
        for (int x : {kRearAxle, kFrontAxle}) c.box({x - 1, 3, 3}, {x + 1, 5, kWidth - 3}, s.iron);
        drawRam(c);
    }
    for (int z : {1, kWidth - 5}) {
        c.box({kLength - 1, 5, z}, {kLength, 7, z + 4}, s.head);
        c.box({0, 5, z}, {1, 7, z + 4}, s.tail);
    }
    c.box({kLength - 1, 4, 5}, {kLength, 7, kWidth - 5}, s.black);  // grille
    c.box({kLength - 1, 4, 7}, {kLength, 5, 11}, s.plate);
    c.box({0, 4, 7}, {1, 5, 11}, s.plate);
    for (int z : {0, kWidth - 1}) {
        for (int x : {13, 22, 30}) c.box({x, 3, z}, {x + 1, 9, z + 1}, s.seam);
        for (int x : {20, 28}) c.box({x, 7, z}, {x + 2, 8, z + 1}, s.steel);
    }
    c.stain({1, 2, 0}, {kLength - 1, 4, kWidth}, s.rust, 8);
    if (hasWheels) c.removeUnanchored();
    return c.finish(std::move(name));
}

/// A tyre on a rim, its axle along z, in voxels of half the size, so that it rolls.
LevelShape makeWheel(std::string name) {
    constexpr int kAcross = 16, kWide = 5;
    Canvas c({kAcross, kAcross, kWide});
    const Swatch rubber = c.addSurface(kRubber), rim = c.addSurface(kSteel), hub = c.addSurface(kDarkSteel);
    c.ring(2, 0, kWide, {kAcross, kAcross, 0}, 10, kAcross, rubber);
    c.ring(2, 1, kWide - 1, {kAcross, kAcross, 0}, 4, 10, rim);
    c.ring(2, 0, kWide, {kAcross, kAcross, 0}, -1, 4, hub);
    LevelShape shape = c.finish(std::move(name));
    shape.voxelSize = float(0.5 * kVoxel);
    shape.collisionShape = CollisionShape::CylinderZ;
    return shape;
}

/// The radius of the smallest cylinder around a wheel's voxels, on which it rolls, metres.
double rollingRadius(const LevelShape& wheel) {
    const ivec3 size = wheel.grid.size();
    double farthest = 0.0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            if (wheel.grid.at({x, y, 0}))
                farthest = std::max(
                    farthest,
                    glm::length(glm::abs(glm::dvec2(x + 0.5, y + 0.5) - 0.5 * glm::dvec2(size.x, size.y)) + 0.5));
    return farthest * double(wheel.voxelSize);
}

}  // namespace

LevelShape makeCar(std::string name, const SurfaceStyle& paint) {
    return makeSaloon(std::move(name), paint, true);
}

size_t addDrivenCar(Level& level, const std::string& name, const SurfaceStyle& paint, ivec3 cell, double throttle) {
    constexpr double kRadius = 0.4, kWide = 0.25;
    constexpr glm::dquat kLeftward(kSqrtHalf, 0.0, kSqrtHalf, 0.0);  // turns +x to -z, the left of a car along +x
    const size_t index = level.bodies.size();
    addDynamic(level, makeSaloon(name, paint, false), cell);
    level.bodies.back().pose.position.y += rollingRadius(makeWheel(name)) - kRadius;
    const Pose car = level.bodies.back().pose;
    for (const int x : {kRearAxle, kFrontAxle})
        for (const bool isLeft : {true, false}) {
            const std::string wheelName = name + (x == kFrontAxle ? " front " : " rear ") + (isLeft ? "left" : "right");
            const glm::dvec3 hub(x * kVoxel, kRadius, isLeft ? 0.5 * kWide : kWidth * kVoxel - 0.5 * kWide);
            const glm::dvec3 middle(kRadius, kRadius, 0.5 * kWide);
            LevelBody wheel{.name = wheelName, .pose = {car.position + hub - middle}, .isStatic = false};
            wheel.shapes.push_back(makeWheel(wheelName));
            level.bodies.push_back(std::move(wheel));
            LevelJoint axle{{.name = wheelName, .kind = JointKind::Wheel}, {name, wheelName}};
            axle.joint.ends[0] = {.frame = {hub, kLeftward}, .radius = 0.4};
            axle.joint.ends[1] = {.frame = {middle, kLeftward}};
            axle.joint.limits = {true, -0.12, 0.12};
            axle.joint.spring = {8.0, 0.6};  // hertz and damping ratio, of the wheel's mass against the car's
            axle.joint.wheel = {
                .driveTorque = 16e3, .maxSpin = 45.0, .brakeTorque = 12e3, .steerAngle = x == kFrontAxle ? 0.5 : 0.0};
            if (throttle != 0.0)
                axle.joint.motor = {MotorMode::Speed, axle.joint.wheel.maxSpin,
                                    throttle * axle.joint.wheel.driveTorque};
            level.joints.push_back(std::move(axle));
        }
    return index;
}

LevelShape makeVan(std::string name, const SurfaceStyle& paint) {
    constexpr int kLength = 50, kWidth = 20, kHeight = 23;
    Canvas c({kLength, kHeight, kWidth});
    const CarSwatches s(c, paint);
    c.box({0, 2, 0}, {kLength, 11, kWidth}, s.paint);
    c.clear({1, 4, 1}, {kLength - 2, 11, kWidth - 1});
    drawCabin(c, s, 11, kHeight - 1, 34, kLength - 1, 0, 3, kWidth);
    c.box({0, 11, 0}, {35, kHeight, kWidth}, s.paint);
    c.clear({1, 4, 1}, {34, kHeight - 1, kWidth - 1});
    c.box({0, 13, 0}, {34, 15, 1}, s.seam);
    c.box({0, 13, kWidth - 1}, {34, 15, kWidth}, s.seam);
    c.box({0, 2, 0}, {kLength, 4, kWidth}, s.black);
    c.box({kLength - 8, 4, 4}, {kLength - 2, 9, kWidth - 4}, s.iron);
    drawSeats(c, s, {37}, kWidth);
    drawWheels(c, s, {9, 40}, kWidth);
    for (int z : {1, kWidth - 4}) {
        c.box({kLength - 1, 6, z}, {kLength, 9, z + 3}, s.head);
        c.box({0, 6, z}, {1, 10, z + 3}, s.tail);
    }
    c.box({kLength - 1, 5, 6}, {kLength, 9, kWidth - 6}, s.black);
    c.box({0, 4, kWidth / 2 - 1}, {1, 21, kWidth / 2}, s.seam);
    c.removeUnanchored();
    return c.finish(std::move(name));
}

}  // namespace rubble::scenes
