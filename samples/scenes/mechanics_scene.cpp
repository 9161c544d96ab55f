// A square with three machines: a Newton's cradle, a plate that spins on its rim, and a pendulum clock.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr glm::dquat kToZ{kSqrtHalf, 0.0, -kSqrtHalf, 0.0};  ///< turns x, the axis of a hinge's frame, to z
constexpr glm::vec3 kAwake{0.001f, 0.0f, 0.0f};              ///< m/s: what does not move in a level begins asleep

/// A turn about z by an angle of this cosine. Only square roots: no sine that differs by library.
glm::dquat turnAboutZ(double cosine) {
    return {std::sqrt(0.5 * (1.0 + cosine)), 0.0, 0.0, -std::sqrt(0.5 * (1.0 - cosine))};
}

/// Hangs the last body by a hinge along z. pivot: world; inShape: the same in the space of the body's shape.
void addHinge(Level& level, const std::string& holder, const std::string& shape, const glm::dvec3& inHolder,
              const glm::dvec3& inShape, JointMotor motor = {}) {
    LevelJoint joint{{.name = shape + " hinge", .kind = JointKind::Hinge}, {holder, shape}};
    joint.joint.ends[0].frame = {inHolder, kToZ};
    joint.joint.ends[1].frame = {inShape, kToZ};
    joint.joint.motor = motor;
    level.joints.push_back(joint);
}

// The cradle

constexpr int kBalls = 5, kAcross = 9, kRod = 24;  // cells
constexpr ivec3 kBeam{78, 36, 140};                // low corner
constexpr ivec3 kBeamSize{100, 3, 3};

bool isInBall(ivec3 cell) {
    const ivec3 d = cell - kAcross / 2;
    return d.x * d.x + d.y * d.y + d.z * d.z <= 20;
}
/// Of the smallest sphere around a ball's voxels, metres: the balls touch as such.
double ballRadius() {
    double farthest = 0.0;
    for (int x = 0; x < kAcross; ++x)
        for (int y = 0; y < kAcross; ++y)
            for (int z = 0; z < kAcross; ++z)
                if (isInBall({x, y, z}))
                    farthest =
                        std::max(farthest, glm::length(glm::abs(glm::dvec3(x, y, z) - 0.5 * (kAcross - 1)) + 0.5));
    return farthest * kVoxel;
}

/// A ball on a rod, as two shapes: a sphere, and voxels that touch nothing.
LevelBody makeCradleBall(int number) {
    const std::string name = "cradle ball " + std::to_string(number);
    Canvas ball(ivec3{kAcross});
    const Swatch paint = ball.addSurface(number == 0 ? kBallRed : kCastSteel);
    ball.fill(ivec3(0), ivec3(kAcross),
              [&](ivec3 cell) { return isInBall(cell) ? PaletteBuilder::pick(paint, cell) : uint8_t(0); });
    Canvas rod({1, kRod, 1});
    rod.box(ivec3(0), {1, kRod, 1}, rod.addSurface(kWire));
    LevelBody body{.name = name, .isStatic = false};
    body.shapes.push_back(ball.finish(name));
    body.shapes.back().collisionShape = CollisionShape::Sphere;
    body.shapes.push_back(rod.finish(name + " rod"));
    body.shapes.back().local.position = atCell(kAcross / 2, kAcross, kAcross / 2);
    return body;
}

void addCradle(Level& level) {
    Canvas frame({kBeamSize.x, kBeam.y + kBeamSize.y, 17});
    const Swatch wood = frame.addSurface(kDarkWood);
    frame.box({0, kBeam.y, 7}, {kBeamSize.x, kBeam.y + kBeamSize.y, 10}, wood);
    for (const int x : {0, kBeamSize.x - 3}) {
        frame.box({x, 0, 7}, {x + 3, kBeam.y, 10}, wood);
        frame.box({x, 0, 0}, {x + 3, 2, 17}, wood);
    }
    const ivec3 corner = kBeam - ivec3(0, kBeam.y, 7);
    addStatic(level, frame.finish("cradle frame"), corner);
    const glm::dvec3 end = atCell(0.5, kRod, 0.5);  // of a rod, in its shape
    for (int i = 0; i < kBalls; ++i) {
        LevelBody body = makeCradleBall(i);
        const glm::dvec3 inBody = body.shapes[1].local.position + end;
        const glm::dvec3 pivot =
            atCell(kBeam.x + 0.5 * kBeamSize.x, kBeam.y, kBeam.z + 1.5) + glm::dvec3((2 * i - 4) * ballRadius(), 0, 0);
        body.pose.rotation = turnAboutZ(i == 0 ? 0.8 : 1.0);  // the first is lifted by 37 degrees
        body.pose.position = pivot - body.pose.rotation * inBody;
        addHinge(level, "cradle frame", body.shapes[1].name, pivot - glm::dvec3(corner) * kVoxel, end);
        if (i == 0) body.velocity = kAwake;
        level.bodies.push_back(std::move(body));
    }
}

// The plate

/// A disc of 1.2 m in voxels of half the size. It stands on its rim, and spins about the vertical.
void addPlate(Level& level) {
    constexpr int kSize = 24, kThick = 2;
    Canvas c({kSize, kSize, kThick});
    const Swatch rim = c.addSurface(kClothBlue), inner = c.addSurface(kWhiteEnamel), middle = c.addSurface(kCarRed);
    c.ring(2, 0, kThick, {kSize, kSize, 0}, 18, kSize, rim);
    c.ring(2, 0, kThick, {kSize, kSize, 0}, 8, 18, inner);
    c.ring(2, 0, kThick, {kSize, kSize, 0}, -1, 8, middle);
    LevelShape shape = c.finish("plate");
    shape.voxelSize = float(0.5 * kVoxel);
    shape.collisionShape = CollisionShape::CylinderZ;
    addDynamic(level, std::move(shape), {206, 0, 150});
    level.bodies.back().pose.position.y = 0.03;  // its smallest cylinder is a little larger than its voxels
    level.bodies.back().angularVelocity = {0.0f, 9.0f, 0.4f};
}

// The clock

constexpr ivec3 kClock{244, 0, 136};  // low corner
constexpr ivec3 kClockSize{16, 42, 10};
constexpr int kFace = 33;  // height of the hands' axis in cells

/// A case that is open in front, with a face above.
LevelShape makeClockCase() {
    Canvas c(kClockSize);
    const Swatch wood = c.addSurface(kRedWood), dark = c.addSurface(kDarkWood), face = c.addSurface(kWhiteEnamel),
                 mark = c.addSurface(kPlasticBlack);
    const auto [w, h, d] = std::array{kClockSize.x, kClockSize.y, kClockSize.z};
    c.box(ivec3(0), kClockSize, wood);
    c.clear({1, 2, 1}, {w - 1, h - 16, d});
    c.box({1, 2, 0}, {w - 1, h - 16, 1}, dark);
    c.clear({0, h - 16, d - 2}, {w, h, d});
    c.ring(2, d - 3, d - 2, {w, 2 * kFace, 0}, -1, 14, face);
    for (const ivec3 at :
         {ivec3(w / 2, kFace + 5, 0), {w / 2, kFace - 6, 0}, {w / 2 + 5, kFace, 0}, {w / 2 - 6, kFace, 0}})
        c.box({at.x, at.y, d - 3}, {at.x + 1, at.y + 1, d - 2}, mark);
    LevelShape shape = c.finish("clock case");
    shape.loadBearing = false;
    return shape;
}

/// A body on a hinge along z. at: the pivot in cells of the clock; inShape: in cells of the body's own.
void addClockPart(Level& level, LevelShape shape, const glm::dvec3& at, const glm::dvec3& inShape, double cosine,
                  JointMotor motor = {}) {
    LevelBody body{.name = shape.name, .isStatic = false};
    body.pose.rotation = turnAboutZ(cosine);
    body.pose.position = (glm::dvec3(kClock) + at) * kVoxel - body.pose.rotation * (inShape * kVoxel);
    addHinge(level, "clock case", shape.name, at * kVoxel, inShape * kVoxel, motor);
    body.shapes.push_back(std::move(shape));
    body.velocity = kAwake;
    level.bodies.push_back(std::move(body));
}

LevelShape makeHand(std::string name, int length) {
    Canvas c({1, length, 1});
    c.box(ivec3(0), {1, length, 1}, c.addSurface(kPlasticBlack));
    return c.finish(std::move(name));
}

void addClock(Level& level) {
    addStatic(level, makeClockCase(), kClock);
    constexpr int kLength = 20, kBob = 5;
    Canvas c({kBob, kLength, 1});
    const Swatch brass = c.addSurface(kCarYellow), rod = c.addSurface(kSteel);
    c.box({kBob / 2, kBob, 0}, {kBob / 2 + 1, kLength, 1}, rod);
    c.ring(2, 0, 1, {kBob, kBob, 0}, -1, kBob, brass);
    const double x = 0.5 * kClockSize.x;
    addClockPart(level, c.finish("pendulum"), {x, 25.5, 5.5}, {0.5 * kBob, kLength - 0.5, 0.5}, 0.9925);
    // The minute hand goes round in twelve seconds, the hour hand twelve times as slowly.
    constexpr double kMinute = -2.0 * std::numbers::pi / 12.0;
    addClockPart(level, makeHand("hour hand", 4), {x, kFace, 8.5}, {0.5, 0.5, 0.5}, 0.8,
                 {MotorMode::Speed, kMinute / 12.0, 1e3});
    addClockPart(level, makeHand("minute hand", 6), {x, kFace, 9.6}, {0.5, 0.5, 0.5}, 1.0,
                 {MotorMode::Speed, kMinute, 1e3});
}

Level mechanicsLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {360, 0, 300};
    ground.areas = {area(Paving, 60, 90, 300, 250)};
    Level level = makePlot("mechanics", ground, seed);
    for (Material& material : level.materials.materials)
        if (material.name == "heavy metal") material.restitution = 1.0f;  // the balls of the cradle
    addCradle(level);
    addPlate(level);
    addClock(level);
    return level;
}

Edits mechanicsScript(int, uint64_t) {
    return {};  // all of it moves from the start
}

Pose mechanicsCamera(double) {
    return lookAt({16.9, 3.4, 30.0}, {16.9, 2.1, 14.0});
}

}  // namespace

Scene mechanicsScene() {
    Scene scene{"mechanics", "a Newton's cradle, a spinning plate and a pendulum clock", mechanicsLevel,
                mechanicsScript, mechanicsCamera};
    scene.verticalFov = 0.70f;
    scene.steps = 720;
    return scene;
}

}  // namespace rubble::scenes
