#include <gtest/gtest.h>

#include "runtime/core/constants.h"
#include "tests/physics/scenes/load_scenes.h"

namespace rubble {
namespace {

/// A plank of 4 m and 80 kg, lying level on a block of 0.4 m at its middle: 62.8 kg at x = 1.6 m, without as much on
/// the other side, tip it at once.
struct Seesaw : PhysicsScene {
    static constexpr int kPlank = 2, kLoad = 3, kCounterweight = 4;
    explicit Seesaw(const PhysicsSettings& settings = {}, double loadMass = 62.8) : PhysicsScene(settings) {
        addFloor();
        add(solidGrid({4, 5, 10}, 7), {-0.2, 0.0, -0.5}, true);
        add(solidGrid({40, 1, 4}, known::entryOfMass(*this, 80.0, 160, 8)), {-2.0, 0.5, -0.2}, false);
        addWeight(loadMass, 9, 1.5);
    }
    void addWeight(double mass, uint8_t entry, double x) {
        add(solidGrid({2, 2, 2}, known::entryOfMass(*this, mass, 8, entry)), {x, 0.6, -0.1}, false);
    }
    /// Loads it awake, and steps until all sleeps: level.
    void loadAtRest() {
        load();
        seconds(10.0);
        for (int i = kPlank; i < int(level.bodies.size()); ++i) ASSERT_TRUE(body(i).asleep) << i;
        ASSERT_LT(tilt(), 1e-3);
    }
    /// Radians by which the plank is tilted, about.
    double tilt() const { return 2.0 * std::abs(body(kPlank).pose.rotation.z); }
};

TEST(Load, APlankTipsWhenItsCounterweightIsDestroyed) {
    for (const PhysicsSettings& settings : {fastPhysics(), balancedPhysics(), accuratePhysics()}) {
        Seesaw scene(settings);
        scene.addWeight(62.8, 10, -1.7);
        scene.loadAtRest();
        scene.stepWith({DestroyBodyEdit{scene.handle(Seesaw::kCounterweight)}});
        scene.seconds(2.0);
        EXPECT_GT(scene.tilt(), 0.2) << settings.substeps;
    }
}

TEST(Load, APlankTipsWhenItsCounterweightIsTakenElsewhere) {
    Seesaw scene;
    scene.addWeight(62.8, 10, -1.7);
    scene.loadAtRest();
    SetBodyEdit move{.body = scene.handle(Seesaw::kCounterweight), .setsPose = true};
    move.pose.position = {5.0, 3.0, 0.0};
    scene.stepWith({move});
    scene.seconds(2.0);
    EXPECT_GT(scene.tilt(), 0.2);
}

TEST(Load, APlankTipsWhenAHandLiftsItsCounterweight) {
    Seesaw scene;
    scene.addWeight(62.8, 10, -1.7);
    scene.loadAtRest();
    const glm::dvec3 at = scene.center(Seesaw::kCounterweight);
    GrabEdit grab{.body = scene.handle(Seesaw::kCounterweight), .point = at, .target = at, .maxForce = 5000.0};
    for (int i = 0; i < 240; ++i) {
        grab.target.y = at.y + 0.002 * i;
        scene.stepWith({grab});
    }
    EXPECT_GT(scene.tilt(), 0.2);
}

/// Nothing falls on it: it is there.
TEST(Load, ASleepingPlankTipsUnderWhatIsSetDownOnIt) {
    for (const double gap : {0.0, 0.001}) {
        Seesaw scene({}, 1.0);
        scene.loadAtRest();
        SetBodyEdit move{.body = scene.handle(Seesaw::kLoad), .setsPose = true, .setsSleep = true};
        move.pose.position = {-1.9, 0.6 + gap, -0.1};
        scene.stepWith({move});
        scene.seconds(3.0);
        EXPECT_LT(scene.tilt(), 0.01) << "1 kg does not tip it";
    }
    for (const double gap : {0.0, 0.001}) {
        Seesaw scene;
        scene.level.bodies.back().pose.position = {5.0, 0.0, 0.0};  // beside it, on the floor
        scene.loadAtRest();
        SetBodyEdit move{.body = scene.handle(Seesaw::kLoad), .setsPose = true, .setsSleep = true};
        move.pose.position = {1.5, 0.6 + gap, -0.1};
        scene.stepWith({move});
        scene.seconds(2.0);
        EXPECT_GT(scene.tilt(), 0.2) << gap;
    }
}

TEST(Load, APlankTipsWhenItsLoadBecomesHeavier) {
    for (const bool byDensity : {false, true}) {
        Seesaw scene({}, 5.0);
        scene.addWeight(5.0, 10, -1.7);
        scene.loadAtRest();
        const BodyHandle load = scene.handle(Seesaw::kLoad);
        if (byDensity)
            scene.stepWith(
                {SetShapeEdit{.shape = scene.body(Seesaw::kLoad).shapes.at(0), .setsDensity = true, .density = 20.0f}});
        else
            scene.stepWith({SetBodyEdit{.body = load, .setsGravityScale = true, .gravityScale = 20.0}});
        scene.seconds(2.0);
        EXPECT_GT(scene.tilt(), 0.2) << byDensity;
    }
}

/// What wakes and is in balance stays so, with all that lies on it: 20 crates, of which the lowest wakes.
TEST(Load, ATowerWhoseFootWakesStandsAndSleepsAgain) {
    PhysicsScene scene;
    scene.addFloor();
    for (int i = 0; i < 10; ++i) scene.add(solidGrid({5, 5, 5}, 5), {0.0, 0.5 * i, 0.0}, false);
    scene.load();
    scene.seconds(10.0);
    const double top = scene.center(10).y;
    scene.stepWith({SetBodyEdit{.body = scene.handle(1), .setsSleep = true}});
    EXPECT_FALSE(scene.body(1).asleep);
    EXPECT_FALSE(scene.body(10).asleep);
    scene.seconds(10.0);
    for (int i = 1; i <= 10; ++i) EXPECT_TRUE(scene.body(i).asleep) << i;
    EXPECT_NEAR(scene.center(10).y, top, 1e-3);
}

/// A slide that friction held falls when that is set to 0, as theory says; so does what a motor held.
TEST(Load, AJointWhoseFrictionOrMotorIsSwitchedOffIsFree) {
    for (const bool byMotor : {false, true}) {
        PhysicsScene scene;
        scene.add(solidGrid({3, 3, 3}, 5), {0.0, 2.0, 0.0}, false);
        Joint& joint =
            known::addJoint(scene, JointKind::Prismatic, "", "body 0", {0.0, 2.0, 0.0}, {0.0, 0.0, 0.0}).joint;
        joint.ends[0].frame.rotation = joint.ends[1].frame.rotation =
            glm::angleAxis(0.5 * kPi, glm::dvec3(0.0, 0.0, 1.0));
        joint.friction = byMotor ? 0.0 : 500.0;
        if (byMotor) joint.motor = {MotorMode::Speed, 0.0, 5000.0};
        scene.load();
        scene.seconds(1.0);
        const double before = scene.center(0).y;
        EXPECT_NEAR(before, 2.15, 0.01);
        scene.stepWith({SetJointMotorEdit{.joint = scene.world.joints().handleAt(0)}});
        scene.seconds(1.0 - scene.stepSeconds);
        EXPECT_NEAR(before - scene.center(0).y, 4.905, 0.1) << byMotor;
    }
}

}  // namespace
}  // namespace rubble
