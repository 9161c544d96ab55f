#include <gtest/gtest.h>

#include <cmath>

#include "physics/shapes/voxel_collider.h"
#include "runtime/core/constants.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/rolling_scenes.h"

namespace rubble {
namespace {

using namespace known;

TEST(Rolling, AWheelOfVoxelsDoesNotHop) {
    for (const int across : {8, 16, 64})
        for (const double speed : {2.0, 20.0}) {
            PhysicsScene scene(sleepless({}));
            addRollingDisc(scene, across, speed);
            scene.load();
            const double start = scene.center(1).y;
            for (int i = 0; i < 120; ++i) {
                scene.step();
                ASSERT_NEAR(scene.center(1).y, start, 0.001) << across << " across at " << speed << " m/s, step " << i;
            }
            EXPECT_NEAR(double(scene.body(1).velocity.x) / speed, 1.0, 0.001) << across << " across";
        }
}

TEST(Rolling, ABallRollsDownASlopeByItsInertia) {
    PhysicsScene scene(sleepless({}));
    const uint8_t entry = setMaterial(scene, 7, 0.8f, 0.0f);
    const glm::dquat tilt = glm::angleAxis(-10.0 * kPi / 180.0, glm::dvec3(0, 0, 1));
    scene.add(solidGrid({400, 4, 40}, entry), tilt * glm::dvec3(-5, -0.4, -2.0), true, tilt);
    LevelShape& ball = scene
                           .add(gridOf(glm::ivec3(16),
                                       [&](glm::ivec3 c) {
                                           const glm::ivec3 d = 2 * c - 15;
                                           return uint8_t(d.x * d.x + d.y * d.y + d.z * d.z <= 256 ? entry : 0);
                                       }),
                                tilt * glm::dvec3(-0.8, 0.1, -0.8), false, tilt)
                           .shapes[0];
    ball.collisionShape = CollisionShape::Sphere;
    scene.load();
    const ColliderPart part(scene.world.shapes().at(scene.body(1).shapes[0]), Pose{}, scene.world.materials());
    ASSERT_TRUE(part.round());
    const double r = 0.1 * double(part.round()->radius);
    scene.seconds(1.0);
    const double before = glm::length(scene.body(1).velocity);
    scene.seconds(1.0);
    const MassProperties mass = bodyMass(scene.world, scene.handle(1));
    const double theory = 9.81 * std::sin(10.0 * kPi / 180.0) / (1.0 + mass.principalInertia.x / (mass.mass * r * r));
    EXPECT_NEAR((glm::length(scene.body(1).velocity) - before) / theory, 1.0, 0.01);
}

/// A ball whose contact is carried along with it, and not found again below it, falls off that and rolls away.
TEST(Rolling, ASmallBallThatIsPutDownStaysThereAndSleeps) {
    for (const double voxel : {0.001, 0.002, 0.01, 0.1})
        for (const double offset : {0.0, 0.3}) {
            PhysicsScene scene;
            scene.add(solidGrid({100, 10, 100}, 7), glm::dvec3(-50, -10, -50) * voxel, true).shapes[0].voxelSize =
                float(voxel);
            LevelShape& ball = scene
                                   .add(gridOf(glm::ivec3(9),
                                               [&](glm::ivec3 c) {
                                                   const glm::ivec3 d = 2 * c - 8;
                                                   return uint8_t(d.x * d.x + d.y * d.y + d.z * d.z <= 81 ? 7 : 0);
                                               }),
                                        glm::dvec3(offset - 4.5, 1.0, offset - 4.5) * voxel, false)
                                   .shapes[0];
            ball.voxelSize = float(voxel);
            ball.collisionShape = CollisionShape::Sphere;
            scene.load();
            const glm::dvec3 start = scene.center(1);
            scene.seconds(4.0);
            const glm::dvec3 way = (scene.center(1) - start) / voxel;
            EXPECT_LT(std::hypot(way.x, way.z), 0.5) << voxel << ", " << offset;
            EXPECT_TRUE(scene.body(1).asleep) << voxel << ", " << offset;
        }
}

TEST(Rolling, AWheelPassesAStepOfOneVoxelAndNoWall) {
    for (const bool isWall : {false, true}) {
        PhysicsScene scene(sleepless({}));
        addRollingDisc(scene, 16, isWall ? 20.0 : 6.0);
        scene.add(isWall ? solidGrid({1, 40, 40}, 7) : solidGrid({40, 1, 40}, 7), {5.0, 0.0, -2.0}, true);
        scene.load();
        double highest = 0.0;
        for (int i = 0; i < 150; ++i) {
            scene.step();
            highest = std::max(highest, scene.center(1).y);
        }
        const double r = rollingRadius(16, 0.1);
        if (isWall)
            EXPECT_LT(scene.center(1).x, 5.0 - r + 0.02);
        else
            EXPECT_GT(scene.center(1).x, 9.5);
        EXPECT_LT(highest, r + (isWall ? 2.5 : 0.5));
    }
}

TEST(Rolling, ACoinLiesFlat) {
    PhysicsScene scene;
    const uint8_t entry = setMaterial(scene, 7, 0.8f, 0.0f);
    scene.addFloor(entry);
    scene.add(disc(16, 2, entry), {-0.8, 0.4, 0.8}, false, glm::angleAxis(-0.5 * kPi + 0.1, glm::dvec3(1, 0, 0)))
        .shapes[0]
        .collisionShape = CollisionShape::CylinderZ;
    scene.load();
    scene.seconds(4.0);
    EXPECT_NEAR(scene.center(1).y, 0.1, 0.002);
    EXPECT_TRUE(scene.body(1).asleep);
}

TEST(Rolling, AnEditMakesAWheelRoundAndWakesIt) {
    PhysicsScene scene;
    addRollingDisc(scene, 8, 0.0, 5.0);
    scene.level.bodies[1].shapes[0].collisionShape = CollisionShape::Voxels;
    scene.load();
    scene.world.applyEdits({});
    scene.seconds(3.0);
    ASSERT_TRUE(scene.body(1).asleep) << "it stands on its lowest voxels";
    const double before = scene.center(1).x;
    const uint64_t hash = scene.world.hash();
    scene.stepWith({SetCollisionShapeEdit{scene.body(1).shapes[0], CollisionShape::CylinderZ}});
    EXPECT_NE(scene.world.hash(), hash);
    scene.seconds(3.0);
    EXPECT_GT(scene.center(1).x, before + 0.3);
}

TEST(Rolling, AWheelThatIsCutIsTouchedAsVoxels) {
    const auto fit = [](const VoxelGrid& grid) {
        return fitRoundSurface(grid, {glm::ivec3(0), grid.size()}, CollisionShape::CylinderZ);
    };
    VoxelGrid wheel = disc(16, 4, 7);
    ASSERT_TRUE(fit(wheel));
    EXPECT_NEAR(double(fit(wheel)->radius), 10.0 * rollingRadius(16, 0.1), 1e-5);
    fillBox(wheel, {{0, 0, 0}, {16, 3, 4}}, 0);
    EXPECT_FALSE(fit(wheel));
    EXPECT_FALSE(fit(solidGrid({6, 6, 6}, 7)));
}

/// Expects an acceleration within 2 %.
void expectAcceleration(const Car& car, double seconds, double theory) {
    EXPECT_NEAR(acceleration(car, seconds) / theory, 1.0, 0.02) << "theory: " << theory << " m/s2";
}

TEST(Rolling, ACarCoastsDrivesAndBrakesByItsTorques) {
    const double r = rollingRadius(kAcross, 0.05), g = 9.81, sine = std::sin(10.0 * kPi / 180.0), drag = 30.0;
    PhysicsScene scene(sleepless({}));
    addCar(scene, {});
    const CarMass mass = massOf(scene);
    const double drive = 4.2 * mass.effective * r / 4.0;
    EXPECT_NEAR(acceleration({.speed = 20.0}, 2.0), 0.0, 0.001);
    expectAcceleration({.drag = drag, .speed = 20.0}, 2.0, -4.0 * drag / r / mass.effective);
    expectAcceleration({.slope = 10.0}, 2.0, g * sine * mass.mass / mass.effective);
    expectAcceleration({.drag = drag, .slope = 10.0}, 2.0, (g * sine * mass.mass - 4.0 * drag / r) / mass.effective);
    expectAcceleration({.drive = drive}, 2.0, 4.2);
    expectAcceleration({.brake = drive, .speed = 20.0}, 2.0, -4.2);
    expectAcceleration({.brake = 10.0 * drive, .speed = 20.0}, 1.0, -0.9 * g);
}

TEST(Rolling, AHeavyCarDrivesAlsoWithWheelsThatSlip) {
    for (const uint32_t density : {400u, 4000u}) {
        PhysicsScene scene(sleepless({}));
        addCar(scene, {.density = density});
        const double grip = 0.9 * 9.81, torque = 2.5 * grip * massOf(scene).mass * rollingRadius(kAcross, 0.05) / 4.0;
        EXPECT_NEAR(acceleration({.drive = torque, .density = density}, 0.5) / grip, 1.0, 0.05) << density;
    }
}

/// The ground is two shapes that meet under a wheel's side, or under its middle.
TEST(Rolling, ASeamAlongTheWheelsNeitherBrakesNorPullsACarAside) {
    for (const int split : {20, 21, 22}) {
        PhysicsScene scene(sleepless({}));
        addCar(scene, {.speed = 20.0, .split = split});
        const double start = scene.center(2).z;
        scene.seconds(1.0);
        EXPECT_NEAR(double(scene.body(2).velocity.x), 20.0, 0.005) << split;
        EXPECT_NEAR(scene.center(2).z, start, 0.001) << split;
    }
}

/// A car of front wheels that stand aslant goes on a circle about a point on its rear axle's line.
TEST(Rolling, ACarTurnsByItsSteeringAngle) {
    for (const double steer : {0.02, 0.05, 0.1, 0.2, 0.3}) {
        const Car car{.steer = steer, .speed = 3.0};
        PhysicsScene scene(sleepless({}));
        addCar(scene, car);
        scene.seconds(1.0);
        const double speed = glm::length(scene.body(1).velocity), tangent = std::tan(steer);
        const double theory = speed * tangent / kWheelBase / std::sqrt(1.0 + 0.25 * tangent * tangent);
        EXPECT_NEAR(double(scene.body(1).angularVelocity.y) / theory, 1.0, 0.05) << steer;
    }
}

/// One command holds: the wheels turn to its angle at their rate, and stay there, whether the car rests or not.
TEST(Rolling, WheelsSteerAtTheirRateAndStay) {
    for (const double rate : {0.02, 0.5, 2.0}) {
        PhysicsScene scene;
        addCar(scene, {});
        for (LevelJoint& joint : scene.level.joints) joint.joint.wheel.steerRate = rate;
        scene.load();
        const auto steered = [&] {  // by the middle of the axle, which is the left front wheel's for small angles
            double sum = 0.0;
            for (int i = 0; i < 4; ++i) {
                const glm::dvec3 axle =
                    glm::conjugate(scene.body(1).pose.rotation) * scene.body(2 + i).pose.rotation * glm::dvec3(0, 0, 1);
                sum += std::atan(axle.x / axle.z);
            }
            return 0.5 * sum;
        };
        for (const double target : {0.1, 0.0}) {
            const double from = steered(), way = target - from;
            scene.stepWith({DriveEdit{scene.handle(1), 0.0, target, 0.0}});
            const auto goOn = [&](double seconds) {
                for (int i = scene.stepsIn(seconds); i > 0; --i) scene.stepWith({});
            };
            goOn(0.5 * std::abs(way) / rate);
            EXPECT_NEAR(steered(), from + 0.5 * way, 0.05 * std::abs(way) + rate / 30.0) << rate << " rad/s";
            goOn(1.0 + std::abs(way) / rate);
            EXPECT_NEAR(steered(), target, 0.002) << rate << " rad/s";
        }
    }
}

/// What drives says one angle: the wheels stand so that all axles meet in one point.
TEST(Rolling, ADrivenCarTurnsOnTheRadiusOfItsWheelBaseAndAngle) {
    for (const double steer : {-0.5, -0.2, 0.1, 0.3, 0.5, 0.8}) {
        PhysicsScene scene(sleepless({}));
        addCar(scene, {.speed = 3.0});
        scene.stepWith({DriveEdit{scene.handle(1), 0.0, steer, 0.0}});
        scene.seconds(1.0);
        const Body& car = scene.body(1);
        const double toAxle = glm::dot(glm::dvec3(car.velocity), car.pose.rotation * glm::dvec3(1, 0, 0));
        const double radius = toAxle / double(car.angularVelocity.y);  // of the middle of the rear axle
        EXPECT_NEAR(radius * std::tan(steer) / kWheelBase, 1.0, 0.05) << steer;
    }
}

/// Bodies spin at 1,000 rad/s at most. A motor that wants more gives the car no spin that its wheels do not have.
TEST(Rolling, AMotorBeyondTheLargestSpinKeepsTheAngularMomentum) {
    for (const double target : {500.0, 1e4}) {
        PhysicsScene scene(sleepless({}));
        addCar(scene, {.drive = 1e5});
        scene.level.environment.gravity = {0, 0, 0};
        scene.level.bodies.erase(scene.level.bodies.begin());
        for (LevelJoint& axle : scene.level.joints) axle.joint.motor.target = target;
        scene.load();
        scene.seconds(1.0);
        glm::dvec3 sum(0.0);
        double ofWheels = 0.0;
        for (int i = 0; i < 5; ++i) {
            const MassProperties mass = bodyMass(scene.world, scene.handle(i));
            const glm::dmat3 axes = glm::mat3_cast(scene.body(i).pose.rotation * mass.principalAxes);
            const glm::dvec3 spin =
                axes * (mass.principalInertia * (glm::transpose(axes) * scene.body(i).angularVelocity));
            sum += spin + glm::cross(scene.center(i), glm::dvec3(scene.body(i).velocity) * mass.mass);
            if (i) ofWheels += glm::length(spin);
        }
        EXPECT_LT(glm::length(sum) / ofWheels, 0.02) << target << " rad/s";
    }
}

}  // namespace
}  // namespace rubble
