#include "tests/physics/scenes/rolling_scenes.h"

#include <algorithm>
#include <cmath>

#include "runtime/core/constants.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble::known {

VoxelGrid disc(int across, int wide, uint8_t entry) {
    return gridOf({across, across, wide}, [&](glm::ivec3 c) {
        const int x = 2 * c.x + 1 - across, y = 2 * c.y + 1 - across;
        return uint8_t(x * x + y * y <= across * across ? entry : 0);
    });
}

double rollingRadius(int across, double voxel) {
    double farthest = 0.0;
    for (int x = 0; x < across; ++x)
        for (int y = 0; y < across; ++y) {
            const int dx = std::abs(2 * x + 1 - across), dy = std::abs(2 * y + 1 - across);
            if (dx * dx + dy * dy > across * across) continue;
            farthest = std::max(farthest, 0.5 * voxel * std::sqrt(double((dx + 1) * (dx + 1) + (dy + 1) * (dy + 1))));
        }
    return farthest;
}

void addRollingDisc(PhysicsScene& scene, int across, double speed, double slope) {
    const uint8_t entry = setMaterial(scene, 7, 0.8f, 0.0f);
    const double r = rollingRadius(across, 0.1);
    const glm::dquat tilt = glm::angleAxis(-slope * kPi / 180.0, glm::dvec3(0, 0, 1));
    scene.add(solidGrid({800, 4, 40}, entry), tilt * glm::dvec3(-5, -0.4, -2.0), true, tilt);
    LevelBody& wheel =
        scene.add(disc(across, 8, entry), tilt * glm::dvec3(-0.05 * across, r - 0.05 * across, -0.4), false, tilt);
    wheel.velocity = glm::vec3(tilt * glm::dvec3(speed, 0, 0));
    wheel.angularVelocity = {0.0f, 0.0f, -float(speed / r)};
    wheel.shapes[0].collisionShape = CollisionShape::CylinderZ;
}

void addCar(PhysicsScene& scene, const Car& car) {
    setMaterial(scene, 7, 0.9f, 0.0f);
    const uint8_t body = setMaterial(scene, 8, 0.9f, 0.0f, car.density);
    const double r = rollingRadius(kAcross, 0.05), half = 0.025 * kAcross;
    const glm::dquat tilt = glm::angleAxis(-car.slope * kPi / 180.0, glm::dvec3(0, 0, 1));
    static const VoxelGrid ground = solidGrid({2000, 4, 1600}, 7);
    if (car.split) {
        const double z = 0.1 * car.split - kGroundSide;
        scene.add(solidGrid({2000, 4, car.split}, 7), tilt * glm::dvec3(-40, -0.4, -kGroundSide), true, tilt);
        scene.add(solidGrid({2000, 4, 200}, 7), tilt * glm::dvec3(-40, -0.4, z), true, tilt);
    } else {
        scene.add(ground, tilt * glm::dvec3(-40, -0.4, -80), true, tilt);
    }
    const glm::vec3 velocity(tilt * glm::dvec3(car.speed, 0, 0));
    scene.add(solidGrid({40, 6, 16}, body), tilt * glm::dvec3(-2, r + 0.1, -0.8), false, tilt).velocity = velocity;
    const std::string name = scene.level.bodies.back().name;
    const glm::dquat leftward(std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0);
    for (const double x : {-0.5 * kWheelBase, 0.5 * kWheelBase})
        for (const bool isLeft : {true, false}) {
            const double z = isLeft ? -0.95 : 0.7;
            LevelBody& wheel = scene.add(disc(kAcross, 5, 7), tilt * glm::dvec3(x - half, r - half, z), false, tilt);
            wheel.shapes[0].voxelSize = 0.05f;
            wheel.shapes[0].collisionShape = CollisionShape::CylinderZ;
            wheel.angularVelocity = glm::vec3(tilt * glm::dvec3(0, 0, -car.speed / r));
            wheel.velocity = velocity;
            LevelJoint axle{{.name = wheel.name, .kind = JointKind::Wheel}, {name, wheel.name}};
            const glm::dvec3 hub(x, r, z + 0.125);
            axle.joint.ends[0] = {.frame = {hub - glm::dvec3(-2, r + 0.1, -0.8), leftward}, .radius = 1.0};
            axle.joint.ends[1] = {.frame = {{half, half, 0.125}, leftward}};
            axle.joint.limits = {true, -0.12, 0.12};
            axle.joint.spring = {8.0, 0.6};
            if (x > 0.0 && car.steer != 0.0)  // each wheel across its own circle
                axle.joint.steer = axle.joint.steerTarget =
                    std::atan(kWheelBase / (kWheelBase / std::tan(car.steer) + z + 0.125));
            axle.joint.friction = car.drag + car.brake;
            axle.joint.wheel = {.steerAngle = x > 0.0 ? 1.0 : 0.0, .steerRate = 100.0};
            if (car.drive > 0.0) axle.joint.motor = {MotorMode::Speed, 1000.0, car.drive};
            scene.level.joints.push_back(axle);
        }
    scene.load();
}

CarMass massOf(const PhysicsScene& scene) {
    CarMass sum;
    const double r = rollingRadius(kAcross, 0.05);
    for (int i = 1; i < int(scene.level.bodies.size()); ++i) {
        const MassProperties mass = bodyMass(scene.world, scene.handle(i));
        sum.mass += mass.mass;
        sum.effective += mass.mass + (i > 1 ? mass.inertia[2] / (r * r) : 0.0);
    }
    return sum;
}
namespace {

double along(const PhysicsScene& scene, const Car& car) {
    const glm::dquat tilt = glm::angleAxis(-car.slope * kPi / 180.0, glm::dvec3(0, 0, 1));
    return glm::dot(glm::dvec3(scene.body(1).velocity), tilt * glm::dvec3(1, 0, 0));
}

}  // namespace

double acceleration(const Car& car, double seconds) {
    PhysicsScene scene(sleepless({}));
    addCar(scene, car);
    scene.seconds(0.5);
    const double before = along(scene, car);
    scene.seconds(seconds);
    return (along(scene, car) - before) / seconds;
}

}  // namespace rubble::known
