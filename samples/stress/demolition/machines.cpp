#include "samples/stress/demolition/machines.h"

#include <fmt/format.h>

#include "samples/scenes/canvas.h"
#include "samples/scenes/car.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/surface_styles.h"

namespace rubble {
namespace {

using namespace scenes;

constexpr ivec3 kYard{680, 0, 0}, kYardSize{260, 14, 220};  // low corner and size with its walls, cells
constexpr int kFloor = 3, kWall = 4;
constexpr ivec3 kBasin = kYard + ivec3(150, kFloor, 120), kBasinSize{80, 11, 80};
constexpr ivec3 kGallows = kYard + ivec3(20, kFloor, 120);
constexpr int kBeamHeight = 60, kBeamLength = 100, kBeamSide = 6;

/// A box of one surface.
LevelShape makeBox(const std::string& name, ivec3 size, const SurfaceStyle& style) {
    Canvas canvas(size);
    canvas.box(ivec3(0), size, canvas.addSurface(style));
    return canvas.finish(name);
}

/// A floor with a wall around it.
LevelShape makeTray(const std::string& name, ivec3 size, const SurfaceStyle& style) {
    Canvas canvas(size);
    canvas.box(ivec3(0), size, canvas.addSurface(style));
    canvas.clear({kWall, kFloor, kWall}, {size.x - kWall, size.y, size.z - kWall});
    return canvas.finish(name);
}

void join(Level& level, Joint joint, const std::string& first, const std::string& second, glm::dvec3 in,
          glm::dvec3 at) {
    joint.ends[0].frame.position = in;
    joint.ends[1].frame.position = at;
    level.joints.push_back({std::move(joint), {first, second}});
}

void addGallows(Level& level) {
    Canvas frame({kBeamLength, kBeamHeight + kBeamSide, kBeamSide});
    const Swatch steel = frame.addSurface(kCarYellow);
    for (const int x : {0, kBeamLength - kBeamSide})
        frame.box({x, 0, 0}, {x + kBeamSide, kBeamHeight, kBeamSide}, steel);
    frame.box({0, kBeamHeight, 0}, {kBeamLength, kBeamHeight + kBeamSide, kBeamSide}, steel);
    addStatic(level, frame.finish("gallows"), kGallows);
    const auto hang = [&](const std::string& name, ivec3 size, int x, int drop) {
        addDynamic(level, makeBox(name, size, kConcrete),
                   kGallows + ivec3(x, kBeamHeight - drop - size.y, kBeamSide / 2 - size.z / 2));
        return glm::dvec3(0.5 * size.x, size.y, 0.5 * size.z) * kVoxel;
    };
    const auto below = [&](double x) { return glm::dvec3(x, kBeamHeight, 0.5 * kBeamSide) * kVoxel; };
    const glm::dvec3 ball = hang("ball", {6, 6, 6}, 17, 40), load = hang("load", {5, 5, 5}, 32, 40);
    join(level, {.kind = JointKind::Rope, .rope = {.points = 20}}, "gallows", "ball", below(20), ball);
    join(level,
         {.name = "winch", .kind = JointKind::Rope, .motor = {MotorMode::Position, 4.0, 1.0}, .rope = {.points = 20}},
         "gallows", "load", below(34.5), load);
    for (int i = 0; i < 5; ++i) {  // a chain
        const glm::dvec3 top = hang(fmt::format("link {}", i), {2, 6, 2}, 49, 6 * i);
        join(level, {.kind = JointKind::Ball, .friction = 1.0}, i ? fmt::format("link {}", i - 1) : "gallows",
             fmt::format("link {}", i), i ? glm::dvec3(top.x, 0.0, top.z) : below(50), top);
    }
    const glm::dvec3 blade = hang("blade", {24, 2, 4}, 58, 0);
    const glm::dquat upright(kSqrtHalf, 0.0, 0.0, kSqrtHalf);  // turns x to y
    Joint hinge{.name = "motor", .kind = JointKind::Hinge, .motor = {MotorMode::Speed, 3.0, 2000.0}, .breakForce = 1e5};
    hinge.ends[0].frame.rotation = hinge.ends[1].frame.rotation = upright;
    join(level, hinge, "gallows", "blade", below(70), blade);
    const glm::dvec3 bob = hang("bob", {4, 4, 4}, 86, 6);
    Joint spring{.kind = JointKind::Prismatic, .limits = {true, -0.5, 0.5}, .spring = {1.5, 0.1}};
    spring.ends[0].frame.rotation = spring.ends[1].frame.rotation = upright;
    join(level, spring, "gallows", "bob", below(88) - glm::dvec3(0.0, 0.6, 0.0), bob);
    level.joints.back().joint.ends[0].radius = 1.0;
}

void addBasin(Level& level) {
    addStatic(level, makeTray("basin", kBasinSize, kTileWhite), kBasin);
    const glm::dvec3 low = glm::dvec3(kBasin + ivec3(kWall, kFloor, kWall)) * kVoxel,
                     high = glm::dvec3(kBasin + kBasinSize - ivec3(kWall, 1, kWall)) * kVoxel;
    level.waters.push_back({.name = "basin",
                            .outline = {{low.x, low.z}, {high.x, low.z}, {high.x, high.z}, {low.x, high.z}},
                            .surface = high.y,
                            .depth = high.y - low.y});
    addDynamic(level, makeBox("raft", {36, 3, 30}, kTimber), kBasin + ivec3(20, 8, 20));
    for (int i = 0; i < 8; ++i)
        addDynamic(level, makeBox(fmt::format("flotsam {}", i), {1 + i % 3, 1 + i % 2, 2}, kTimber),
                   kBasin + ivec3(8 + i * 8, 9, 60 + i % 3 * 4));
    join(level, {.kind = JointKind::Rope, .rope = {.length = 2.5, .points = 8}}, "basin", "raft",
         glm::dvec3(kWall, 10, 35) * kVoxel, glm::dvec3(0, 2, 15) * kVoxel);
}

}  // namespace

void addMachines(Level& level) {
    addStatic(level, makeTray("yard", kYardSize, kConcrete), kYard);
    addDrivenCar(level, "car 1", kCarRed, kYard + ivec3(20, kFloor, 20), 0.5);
    addDrivenCar(level, "car 2", kCarBlue, kYard + ivec3(120, kFloor, 60), 0.3);
    addGallows(level);
    addBasin(level);
    for (int i = 0; i < 3; ++i) {
        level.characters.emplace_back();
        level.characters.back().position = glm::dvec3(kYard + ivec3(60 + 40 * i, kFloor + 1, 100)) * kVoxel;
    }
}

Edits randomCommand(const World& world, Random& random) {
    const double a = 2.0 * double(random.unit()) - 1.0, b = 2.0 * double(random.unit()) - 1.0;
    const uint32_t kind = random.below(4), index = random.below(3);
    Edits edits;
    if (kind == 0)
        world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (body.name == fmt::format("car {}", 1 + index % 2)) edits.push_back(DriveEdit{handle, a, b, 0.0});
        });
    if (kind == 1)
        world.joints().forEach([&](JointHandle handle, const Joint& joint) {
            JointMotor motor = joint.motor;
            if (joint.name == "winch") motor.target = 3.0 + 2.0 * a;
            if (joint.name == "motor") motor.target = 6.0 * b;
            if (motor.target != joint.motor.target) edits.push_back(SetJointMotorEdit{handle, motor});
        });
    if (kind > 1) {
        uint32_t i = 0;
        world.characters().forEach([&](CharacterHandle handle, const Character&) {
            if (i++ == index) edits.push_back(MoveCharacterEdit{handle, {4.0 * a, 0.0, 4.0 * b}, random.below(4) == 0});
        });
    }
    return edits;
}

}  // namespace rubble
