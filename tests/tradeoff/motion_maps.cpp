#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/core/constants.h"
#include "tests/physics/scenes/joint_scenes.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/rolling_scenes.h"
#include "tests/physics/scenes/rope_scenes.h"
#include "tests/physics/scenes/seam_scenes.h"
#include "tests/tradeoff/physics_map.h"

namespace rubble::tradeoff {
namespace {

using namespace known;

Judged judgeError(double error, double stable, double degraded) {
    return judge(std::abs(error), stable, degraded, fmt::format("{:.2g} %", error * 100.0));
}

/// Metres by which a wheel that rolls for 2 s leaves its height, and the share of its speed that it loses.
Judged judgeWheel(double speed, int across) {
    PhysicsScene scene(sleepless({}));
    addRollingDisc(scene, across, speed);
    scene.load();
    const double start = scene.center(1).y;
    double hop = 0.0;
    for (int i = 0; i < 120 && scene.center(1).x < 70.0; ++i) {
        scene.step();
        hop = std::max(hop, std::abs(scene.center(1).y - start));
    }
    const double lost = std::abs(scene.body(1).velocity.x / speed - 1.0);
    return judge(std::max(hop, lost), 0.001, 0.01, fmt::format("{:.2g} mm\n{:.2g} %", hop * 1e3, lost * 100.0));
}

/// The acceleration of a car by its drive, brake or rolling resistance, m/s2, against its torques. row: which.
Judged judgeCar(double wanted, size_t row, bool) {
    PhysicsScene scene(sleepless({}));
    addCar(scene, {});
    const double torque = wanted * massOf(scene).effective * rollingRadius(kAcross, 0.05) / 4.0;
    Car car;
    (row == 0 ? car.drive : row == 1 ? car.brake : car.drag) = torque;
    if (row > 0) car.speed = 20.0;
    const double seconds = row > 0 ? std::min(2.0, 15.0 / wanted) : 1.5;
    return judgeError(acceleration(car, seconds) / (row > 0 ? -wanted : wanted) - 1.0, 0.02, 0.1);
}

/// The radius of a car's turn at a speed, against its wheel base and steering angle.
Judged judgeTurn(double speed, double steer) {
    PhysicsScene scene(sleepless({}));
    addCar(scene, {.speed = speed});
    scene.stepWith({DriveEdit{scene.handle(1), 0.0, steer, 0.0}});
    scene.seconds(1.0);
    const Body& car = scene.body(1);
    const double toAxle = glm::dot(glm::dvec3(car.velocity), car.pose.rotation * glm::dvec3(1, 0, 0));
    return judgeError(toAxle / double(car.angularVelocity.y) * std::tan(steer) / kWheelBase - 1.0, 0.05, 0.2);
}

/// Seconds after which a pile of cubes that fell into a box sleeps.
Judged judgePile(double side, size_t row, bool) {
    const CollisionShape shapes[] = {CollisionShape::Voxels, CollisionShape::Sphere};
    PhysicsScene scene;
    scene.addFloor();
    const int n = int(side), half = 3 * n + 4;
    for (int wall = 0; wall < 4; ++wall) {
        const double away = 0.1 * half + (wall % 2 ? 0.0 : 0.2);
        const glm::dvec3 corner = wall < 2 ? glm::dvec3(wall ? away : -away, 0.0, -0.1 * half - 0.2)
                                           : glm::dvec3(-0.1 * half - 0.2, 0.0, wall == 3 ? away : -away);
        scene.add(
            solidGrid(wall < 2 ? glm::ivec3(2, 4 * half, 2 * half + 4) : glm::ivec3(2 * half + 4, 4 * half, 2), 7),
            corner, true);
    }
    const int first = int(scene.level.bodies.size());
    const VoxelGrid ball = gridOf(glm::ivec3(5), [](glm::ivec3 c) {
        const glm::ivec3 d = c - 2;
        return uint8_t(d.x * d.x + d.y * d.y + d.z * d.z <= 6 ? 7 : 0);
    });
    for (int i = 0; i < n * n * n; ++i)
        scene
            .add(row ? ball : solidGrid({5, 5, 5}, 7),
                 glm::dvec3(i % n - 0.5 * n, i / n / n + 0.5, i / n % n - 0.5 * n) * 0.58 +
                     glm::dvec3(0.01 * (i % 3), 0.0, 0.01 * (i % 5)),
                 false)
            .shapes[0]
            .collisionShape = shapes[row];
    scene.load();
    double seconds = 0.0;
    int awake = n * n * n;
    while (awake && seconds < 40.0) {
        scene.seconds(0.5);
        seconds += 0.5;
        awake = 0;
        for (int i = 0; i < n * n * n; ++i) awake += !scene.body(first + i).asleep;
    }
    return judge(awake ? 1e9 : seconds, 15.0, 30.0,
                 awake ? fmt::format("{} awake", awake) : fmt::format("{:g} s", seconds));
}

/// The time between two passages of a pendulum through its lowest place, against theory; one that slept has none.
Judged judgePendulum(double period, double amplitude) {
    PhysicsScene scene;
    const double length = 9.81 * period * period / (4.0 * kPi * kPi);
    scene.add(solidGrid({4, 4, 4}, 7), {amplitude - 0.2, -length - 0.2, -0.2}, false);
    addJoint(scene.level, JointKind::Hinge, -1, 0, hingeAt({0, 0, 0})).joint.ends[1].cell = {0, 0, 0};
    scene.load();
    std::vector<double> passages;
    double last = scene.center(0).x;
    for (int i = 1; i < scene.stepsIn(2.0 * period) && passages.size() < 2; ++i) {
        scene.step();
        const double now = scene.center(0).x;
        if (last * now < 0.0) passages.push_back((i - 1 + last / (last - now)) * scene.stepSeconds);
        last = now;
    }
    if (passages.size() < 2) return {Outcome::Failed, "stops"};
    return judgeError((passages[1] - passages[0]) / (0.5 * period) - 1.0, 0.02, 0.1);
}

/// How what rides over flush tiles departs from what rides over one slab: share of the way, and the hop in mm.
Judged judgeSeam(double speed, size_t row, bool) {
    const VoxelGrid crate = solidGrid({6, 6, 6}, 7);
    const Rider riders[] = {{crate, speed, 0.3, 0.2},
                            {crate, speed, 0.0, 0.5},
                            {disc(8, 3, 7), speed, 0.8, 0.0, CollisionShape::CylinderZ}};
    const glm::dquat turn(1, 0, 0, 0);
    const Ride slab = rideOver(Tiles::Slab, riders[row], turn);
    double off = 0.0, hop = 0.0;
    for (const Tiles tiles : {Tiles::Shapes, Tiles::Bodies, Tiles::TurnedBodies, Tiles::DynamicShapes}) {
        const Ride ride = rideOver(tiles, riders[row], turn);
        off = std::max(off, std::abs(ride.distance / slab.distance - 1.0));
        hop = std::max(hop, ride.highest);
    }
    return judge(std::max(off, 20.0 * hop), 0.02, 0.1, fmt::format("{:.2g} %\n{:.2g} mm", off * 100.0, hop * 1e3));
}

/// The worst phase of the step for a crate that slides over a gap: share of its speed, and the hop in mm.
Judged judgeGap(double speed, double gap) {
    double lost = 0.0, hop = 0.0;
    for (const Tiles tiles : {Tiles::Shapes, Tiles::Bodies, Tiles::DynamicShapes})
        for (const double beyond : {0.00003, 0.0001, 0.001, 0.006}) {
            const GapRide ride = rideOverGap({tiles, 0.1, gap, speed, beyond});
            lost = std::max(lost, std::abs(ride.lost)), hop = std::max(hop, ride.highest);
        }
    return judge(std::max(lost, 20.0 * hop), 0.02, 0.1, fmt::format("{:.2g} %\n{:.2g} mm", lost * 100.0, hop * 1e3));
}

Judged judgeBeam(double drop, int thickness) {
    const BeamRope rope = dropOverBeam({}, {.thickness = thickness, .mass = 100.0, .drop = drop});
    return judge(rope.isOver ? std::abs(rope.below) : 1e9, 0.2, 0.5, fmt::format("{:.2g} m", rope.below));
}

Judged judgeHeldEnd(double anchor, int thickness) {
    const BeamRope rope = dropOverBeam({}, {.thickness = thickness, .mass = 100.0, .anchor = anchor});
    return judge(rope.isOver ? std::abs(rope.below) : 1e9, 0.2, 0.5, fmt::format("{:.2g} m", rope.below));
}

}  // namespace

std::vector<Map> rollingMaps() {
    const std::vector<double> across{8, 16, 64}, angles{0.05, 0.1, 0.3, 0.5, 0.8};
    return {
        {"T13-wheel",
         "wheels of voxels that roll",
         "they hop by at most 1 mm and keep 99.9 % of their speed in 2 s; degraded: 1 cm, 99 %",
         "speed, m/s",
         "m/s",
         {2, 5, 20, 50},
         {100, 200},
         "voxels across",
         namesOf(across),
         [across](double speed, size_t row, bool) { return judgeWheel(speed, int(across[row])); }},
        {"T13-car",
         "a car that is driven and braked",
         "its acceleration is within 2 % of its torques, though an axle with little load slips; degraded: 10 %",
         "acceleration, m/s2",
         "m/s2",
         {0.2, 1, 4, 7},
         {8, 10},
         "by",
         {"drive", "brake", "rolling resistance"},
         judgeCar},
        {"T13-turn",
         "a car that turns, without regard to grip",
         "its radius is within 5 % of wheel base and steering angle; degraded: 20 %",
         "speed, m/s",
         "m/s",
         {1, 3, 5},
         {8, 12, 20},
         "angle, radians",
         namesOf(angles),
         [angles](double speed, size_t row, bool) { return judgeTurn(speed, angles[row]); }},
    };
}

std::vector<Map> sleepAndSeamMaps() {
    const std::vector<double> amplitudes{0.15, 0.5, 1.0}, thicknesses{1, 2, 3, 4}, gaps{0.02, 0.07, 0.15};
    return {
        {"T13-pile-sleep",
         "piles in a box that fall asleep",
         "all sleep within 15 s; degraded: 30 s",
         "things along a side",
         "things",
         {2, 3, 4},
         {6, 8},
         "of",
         {"cubes", "balls"},
         judgePile},
        {"T13-slow-pendulum",
         "slow pendulums that must not sleep",
         "half a swing takes its time within 2 %; degraded: 10 %",
         "period, s",
         "s",
         {5, 10, 20},
         {40, 60},
         "amplitude, m",
         namesOf(amplitudes),
         [amplitudes](double period, size_t row, bool) { return judgePendulum(period, amplitudes[row]); }},
        {"T13-seams",
         "things that go over flush tiles",
         "they go as far as over one slab within 2 % and hop by at most 1 mm; degraded: 10 %, 5 mm",
         "speed, m/s",
         "m/s",
         {1, 5, 20},
         {40, 80},
         "what",
         {"crate", "crate without friction", "wheel"},
         judgeSeam},
        {"T13-gaps",
         "a crate of 0.4 m that slides over a gap",
         "it loses at most 2 % of its speed and hops by at most 1 mm; degraded: 10 %, 5 mm",
         "speed, m/s",
         "m/s",
         {0.5, 2, 6, 20},
         {30, 40},
         "gap, m",
         namesOf(gaps),
         [gaps](double speed, size_t row, bool) { return judgeGap(speed, gaps[row]); }},
        {"T13-rope-beam",
         "a load on a rope over a thin beam",
         "it hangs within 0.2 m of theory; degraded: 0.5 m",
         "drop, m",
         "m",
         {0, 1, 5, 20},
         {50, 90},
         "beam, voxels",
         namesOf(thicknesses),
         [thicknesses](double drop, size_t row, bool) { return judgeBeam(drop, int(thicknesses[row])); }},
        {"T13-rope-end",
         "a load on a rope round a beam next to its held end",
         "it hangs within 0.2 m of theory; degraded: 0.5 m",
         "distance of the end, m",
         "m",
         {0.5, 0.3, 0.2, 0.1, 0.05},
         {0},
         "beam, voxels",
         namesOf(thicknesses),
         [thicknesses](double anchor, size_t row, bool) { return judgeHeldEnd(anchor, int(thicknesses[row])); }},
    };
}

}  // namespace rubble::tradeoff
