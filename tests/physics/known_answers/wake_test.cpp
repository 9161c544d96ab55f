#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "runtime/core/constants.h"
#include "tests/physics/scenes/joint_scenes.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/rolling_scenes.h"

// Each change that can move what sleeps wakes it.

namespace rubble {
namespace {

constexpr uint8_t kRough = 7, kOther = 9, kSlippery = 11;  ///< materials and their palette entries

/// A change of something, in a scene in which one body sleeps.
struct Change {
    std::string name;
    std::function<void(PhysicsScene&)> build;         ///< adds all bodies; body 0 is the ground
    std::function<Edits(const PhysicsScene&)> edits;  ///< that change it
    int body = 1;                                     ///< which sleeps
    double least = 0.05;                              ///< metres by which it must move within 3 s
};

/// A rough plane, tilted about z: downward along x.
void addSlope(PhysicsScene& scene, double degrees) {
    known::setMaterial(scene, kRough, 0.8f, 0.0f);
    known::setMaterial(scene, kOther, 0.8f, 0.0f);
    known::setMaterial(scene, kSlippery, 0.0f, 0.0f);
    const glm::dquat tilt = glm::angleAxis(-degrees * kPi / 180.0, glm::dvec3(0, 0, 1));
    scene.add(solidGrid({200, 4, 40}, kRough), tilt * glm::dvec3(-5.0, -0.4, -2.0), true, tilt);
}
/// A body on the plane of addSlope().
LevelBody& addOnSlope(PhysicsScene& scene, VoxelGrid grid) {
    const glm::dvec3 half = 0.05 * glm::dvec3(grid.size());
    const glm::dquat tilt = scene.level.bodies[0].pose.rotation;
    return scene.add(std::move(grid), tilt * glm::dvec3(-half.x, 0.0, -half.z), false, tilt);
}
void crateOnSlope(PhysicsScene& scene) {
    addSlope(scene, 20.0);
    addOnSlope(scene, solidGrid({4, 4, 4}, kOther));
}
void ballOnSlope(PhysicsScene& scene) {
    addSlope(scene, 3.0);
    addOnSlope(scene, gridOf(glm::ivec3(8), [](glm::ivec3 c) {
                   const glm::ivec3 d = 2 * c - 7;
                   return uint8_t(d.x * d.x + d.y * d.y + d.z * d.z <= 64 ? kOther : 0);
               }));
}
void wheelOnSlope(PhysicsScene& scene) {
    addSlope(scene, 3.0);
    addOnSlope(scene, known::disc(8, 4, kOther));
}
void crateOnFloor(PhysicsScene& scene) {
    scene.addFloor(kRough);
    scene.add(solidGrid({4, 4, 4}, kOther), {-0.2, 0.0, -0.2}, false);
}
/// On a ball that its floor bears as a sphere: its voxels reach less far down.
void roundOnFloor(PhysicsScene& scene) {
    scene.addFloor(kRough);
    scene.add(known::disc(6, 6, kOther), {-0.3, 0.05, -0.3}, false).shapes[0].collisionShape =
        CollisionShape::CylinderZ;
}
/// A crate on a table, body 1, that stands on the floor.
void crateOnTable(PhysicsScene& scene) {
    scene.addFloor(kRough);
    scene.add(solidGrid({10, 5, 10}, kRough), {-0.5, 0.0, -0.5}, true);
    scene.add(solidGrid({4, 4, 4}, kOther), {-0.2, 0.5, -0.2}, false);
}
/// A plank on a block in balance: a weight on each end of it, bodies 3 and 4.
void seesaw(PhysicsScene& scene) {
    scene.addFloor(kRough);
    scene.add(solidGrid({4, 5, 10}, kRough), {-0.2, 0.0, -0.5}, true);
    known::setMaterial(scene, kOther, 0.6f, 0.0f, 500);
    scene.add(solidGrid({40, 1, 4}, kOther), {-2.0, 0.5, -0.2}, false);
    for (const double x : {-1.9, 1.5}) scene.add(solidGrid({4, 4, 4}, kOther), {x, 0.6, -0.2}, false);
}
void addPool(PhysicsScene& scene, double surface) {
    scene.level.waters.push_back(
        {.name = "pool", .outline = {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, .surface = surface, .depth = surface});
}
/// A crate of half the water's density that floats.
void floatingCrate(PhysicsScene& scene) {
    scene.addFloor(kRough);
    known::setMaterial(scene, kOther, 0.6f, 0.0f, 500);
    scene.add(solidGrid({4, 4, 4}, kOther), {-0.2, 1.8, -0.2}, false);
    addPool(scene, 2.0);
}
void lightCrateOnFloor(PhysicsScene& scene) {
    crateOnFloor(scene);
    known::setMaterial(scene, kOther, 0.6f, 0.0f, 500);
}
/// A crate beside the level.
void crateOnFields(PhysicsScene& scene) {
    scene.addFloor(kRough);
    scene.add(solidGrid({4, 4, 4}, kOther), {12.0, 0.0, 0.0}, false);
    WorldSettings settings;
    settings.bounds.rule = BoundsRule::Ground;
    scene.world.setSettings(settings);
}
/// A crate that hangs below a ceiling, held by a joint of a kind.
void hangingCrate(PhysicsScene& scene, JointKind kind) {
    scene.add(solidGrid({10, 2, 10}, kRough), {-0.5, 2.0, -0.5}, true);
    scene.add(solidGrid({4, 4, 4}, kOther), {-0.2, 1.6, -0.2}, false);
    LevelJoint& joint = known::addJoint(scene.level, kind, 0, 1, {{0.0, 2.0, 0.0}});
    joint.joint.ends[0].cell = {5, 0, 5};
    joint.joint.ends[1].cell = {2, 3, 2};
}

ShapeHandle shapeOf(const PhysicsScene& scene, int body) {
    return scene.body(body).shapes[0];
}
JointHandle onlyJoint(const PhysicsScene& scene) {
    JointHandle found;
    scene.world.joints().forEach([&](JointHandle handle, const Joint&) { found = handle; });
    return found;
}
Edits withFriction(const PhysicsScene& scene, uint8_t material, float friction) {
    Material slippery = scene.world.materials()[material];
    slippery.friction = friction;
    return {SetMaterialsEdit{material, {slippery}}};
}
Edits withCollisionShape(const PhysicsScene& scene, CollisionShape kind) {
    return {SetCollisionShapeEdit{shapeOf(scene, 1), kind}};
}
Edits withGravity(const PhysicsScene& scene, glm::vec3 gravity) {
    Environment environment = scene.world.environment();
    environment.gravity = gravity;
    return {SetEnvironmentEdit{environment}};
}

std::vector<Change> changesOfShapes() {
    return {
        {"a ball becomes round", ballOnSlope,
         [](const PhysicsScene& s) { return withCollisionShape(s, CollisionShape::Sphere); }},
        {"a cube becomes round",
         [](PhysicsScene& s) {
             addSlope(s, 20.0);
             addOnSlope(s, solidGrid({2, 2, 2}, kOther));
         },
         [](const PhysicsScene& s) { return withCollisionShape(s, CollisionShape::Sphere); }},
        {"a wheel becomes round", wheelOnSlope,
         [](const PhysicsScene& s) { return withCollisionShape(s, CollisionShape::CylinderZ); }},
        {"what is round becomes voxels", roundOnFloor,
         [](const PhysicsScene& s) { return withCollisionShape(s, CollisionShape::Voxels); }, 1, 0.004},
        {"the collision mask", crateOnTable,
         [](const PhysicsScene& s) {
             return Edits{SetCollisionFilterEdit{shapeOf(s, 2), 1, 0}};
         },
         2},
        {"the collision layer of what bears it", crateOnTable,
         [](const PhysicsScene& s) {
             return Edits{SetCollisionFilterEdit{shapeOf(s, 1), 0, 255}};
         },
         2},
        {"the density of a counterweight", seesaw,
         [](const PhysicsScene& s) {
             return Edits{SetShapeEdit{.shape = shapeOf(s, 4), .setsDensity = true, .density = 8.0f}};
         },
         2, 0.02},
        {"the density of what floats", floatingCrate,
         [](const PhysicsScene& s) {
             return Edits{SetShapeEdit{.shape = shapeOf(s, 1), .setsDensity = true, .density = 1.8f}};
         }},
        {"voxels under it", crateOnTable,
         [](const PhysicsScene&) {
             return Edits{CarveEdit{.kind = BrushKind::Box, .position = {0.0, 0.25, 0.0}, .halfSize = {0.4, 0.2, 0.4}}};
         },
         2},
        {"voxels written under it", crateOnFloor,
         [](const PhysicsScene& s) {
             return Edits{WriteVoxelsEdit{shapeOf(s, 0), {{95, 5, 95}, {105, 10, 105}}, std::vector<uint8_t>(500, 0)}};
         }},
        {"voxels written into it", crateOnTable,
         [](const PhysicsScene& s) {
             return Edits{ResizeShapeEdit{shapeOf(s, 1), {{0, 0, 0}, {10, 8, 10}}},
                          WriteVoxelsEdit{shapeOf(s, 1), {{0, 5, 0}, {2, 8, 10}}, std::vector<uint8_t>(60, kRough)},
                          WriteVoxelsEdit{shapeOf(s, 1), {{2, 5, 0}, {4, 6, 10}}, std::vector<uint8_t>(20, kRough)}};
         },
         2, 0.0},
        {"anchors of what bears it",
         [](PhysicsScene& s) {
             crateOnTable(s);
             for (int i : {1, 2}) s.level.bodies[size_t(i)].pose.position.y += 1.0;
         },
         [](const PhysicsScene& s) {
             return Edits{SetShapeEdit{.shape = shapeOf(s, 1), .anchorChange = AnchorChange::Boxes, .anchors = {}}};
         },
         2},
    };
}

std::vector<Change> changesOfMaterials() {
    return {
        {"the friction of its material", crateOnSlope,
         [](const PhysicsScene& s) { return withFriction(s, kOther, 0.0f); }},
        {"the friction of what bears it", crateOnSlope,
         [](const PhysicsScene& s) { return withFriction(s, kRough, 0.0f); }},
        {"its palette", crateOnSlope,
         [](const PhysicsScene& s) {
             return Edits{SetPaletteEdit{shapeOf(s, 1), false, kOther, {PaletteEntry{.material = kSlippery}}}};
         }},
        {"the palette of what bears it", crateOnSlope,
         [](const PhysicsScene& s) {
             return Edits{SetPaletteEdit{shapeOf(s, 0), false, kRough, {PaletteEntry{.material = kSlippery}}}};
         }},
        {"what bears it becomes unphysical", crateOnSlope,
         [](const PhysicsScene& s) {
             Material ghost = s.world.materials()[kRough];
             ghost.hardness = Hardness::Unphysical;
             return Edits{SetMaterialsEdit{kRough, {ghost}}};
         }},
        {"the density of the material of what floats", floatingCrate,
         [](const PhysicsScene& s) {
             Material heavy = s.world.materials()[kOther];
             heavy.density = 900;
             return Edits{SetMaterialsEdit{kOther, {heavy}}};
         }},
    };
}

std::vector<Change> changesOfBodies() {
    return {
        {"its gravity scale", crateOnFloor,
         [](const PhysicsScene& s) {
             return Edits{SetBodyEdit{.body = s.handle(1), .setsGravityScale = true, .gravityScale = -0.5}};
         }},
        {"its velocity", crateOnFloor,
         [](const PhysicsScene& s) {
             return Edits{SetBodyEdit{.body = s.handle(1), .setsVelocity = true, .velocity = {2, 0, 0}}};
         }},
        {"the gravity scale of a counterweight", seesaw,
         [](const PhysicsScene& s) {
             return Edits{SetBodyEdit{.body = s.handle(4), .setsGravityScale = true, .gravityScale = 4.0}};
         },
         2, 0.02},
        {"what bears it becomes free", crateOnTable,
         [](const PhysicsScene& s) {
             return Edits{
                 SetBodyEdit{.body = s.handle(1), .setsPose = true, .pose = {{-0.5, 0.1, -0.5}}, .setsKind = true}};
         },
         2, 0.02},
        {"what bears it goes away", crateOnTable,
         [](const PhysicsScene& s) {
             return Edits{SetBodyEdit{.body = s.handle(1), .setsPose = true, .pose = {{3.0, 0.0, 3.0}}}};
         },
         2},
        {"what bears it is destroyed", crateOnTable,
         [](const PhysicsScene& s) { return Edits{DestroyBodyEdit{s.handle(1)}}; }, 2},
        {"the shape that bears it is destroyed", crateOnTable,
         [](const PhysicsScene& s) { return Edits{DestroyShapeEdit{shapeOf(s, 1)}}; }, 2},
        {"a wall moves into it",
         [](PhysicsScene& s) {
             crateOnFloor(s);
             s.add(solidGrid({2, 10, 10}, kRough), {3.0, 0.0, -0.5}, true);
         },
         [](const PhysicsScene& s) {
             return Edits{SetBodyEdit{.body = s.handle(2), .setsPose = true, .pose = {{0.1, 0.0, -0.5}}}};
         }},
        {"a wall is made in it", crateOnFloor,
         [](const PhysicsScene& s) {
             CreateShapeEdit wall{
                 .body = s.handle(0), .source = ShapeSource::Box, .size = {2, 10, 10}, .entry = kRough};
             wall.shape.palette = s.palette;
             wall.shape.voxelSize = 0.1f;
             wall.shape.local.position = {10.1, 1.0, 9.5};
             return Edits{wall};
         }},
        {"a sleeping body is put into it",
         [](PhysicsScene& s) {
             crateOnFloor(s);
             s.add(solidGrid({4, 4, 4}, kOther), {3.0, 0.0, 0.0}, false);
         },
         [](const PhysicsScene& s) {
             return Edits{SetBodyEdit{
                 .body = s.handle(2), .setsPose = true, .pose = {{0.1, 0.0, -0.2}}, .setsSleep = true, .asleep = true}};
         },
         1, 0.03},
        {"it gets a shape", crateOnFloor,
         [](const PhysicsScene& s) {
             CreateShapeEdit beam{.body = s.handle(1), .source = ShapeSource::Box, .size = {20, 1, 1}, .entry = kOther};
             beam.shape.palette = s.palette;
             beam.shape.voxelSize = 0.1f;
             beam.shape.local.position = {0.4, 0.3, 0.0};
             return Edits{beam};
         }},
    };
}

std::vector<Change> changesOfSurroundings() {
    return {
        {"gravity grows aside", crateOnFloor,
         [](const PhysicsScene& s) {
             return withGravity(s, {9.0f, -9.81f, 0.0f});
         }},
        {"water comes", lightCrateOnFloor,
         [](const PhysicsScene&) {
             return Edits{AddWaterEdit{
                 {.name = "pool", .outline = {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, .surface = 2.0, .depth = 2.0}}};
         }},
        {"water goes", floatingCrate,
         [](const PhysicsScene& s) {
             WaterHandle water;
             s.world.waters().forEach([&](WaterHandle handle, const Water&) { water = handle; });
             return Edits{RemoveWaterEdit{water}};
         }},
        {"the fields get soft", crateOnFields,
         [](const PhysicsScene&) { return Edits{SetBoundsEdit{{.rule = BoundsRule::Keep}}}; }},
        {"an impulse", crateOnFloor,
         [](const PhysicsScene& s) {
             return Edits{ImpulseEdit{s.handle(1), s.center(1), {500.0, 0.0, 0.0}}};
         }},
        {"an explosion", crateOnFloor,
         [](const PhysicsScene&) {
             return Edits{ExplodeEdit{.position = {0.9, 0.3, 0.0}, .size = 0.8}};
         }},
        {"a hand", crateOnFloor,
         [](const PhysicsScene& s) {
             return Edits{GrabEdit{.body = s.handle(1),
                                   .point = s.center(1),
                                   .target = s.center(1) + glm::dvec3(0, 1, 0),
                                   .maxForce = 1e4}};
         }},
    };
}

std::vector<Change> changesOfJoints() {
    const auto welded = [](PhysicsScene& s) { hangingCrate(s, JointKind::Fixed); };
    const auto hinged = [](PhysicsScene& s) { hangingCrate(s, JointKind::Hinge); };
    return {
        {"a joint is removed", welded, [](const PhysicsScene& s) { return Edits{RemoveJointEdit{onlyJoint(s)}}; }},
        {"a joint is detached", welded,
         [](const PhysicsScene& s) {
             return Edits{DetachJointEdit{onlyJoint(s), shapeOf(s, 1)}};
         }},
        {"the voxel of a joint is carved", welded,
         [](const PhysicsScene&) {
             return Edits{
                 CarveEdit{.kind = BrushKind::Box, .position = {0.05, 1.95, 0.05}, .halfSize = {0.06, 0.06, 0.06}}};
         }},
        {"a motor begins to turn", hinged,
         [](const PhysicsScene& s) {
             return Edits{SetJointMotorEdit{onlyJoint(s), {MotorMode::Speed, 1.0, 1e5}}};
         }},
        {"a spring joint is added", crateOnFloor,
         [](const PhysicsScene& s) {
             AddJointEdit add{.inWorld = true};
             add.joint.kind = JointKind::Ball;
             add.joint.ends[0] = {.frame = {{-0.1, 0.35, 0.0}}, .radius = 0.2};
             add.joint.ends[0].shape = shapeOf(s, 1);
             add.joint.ends[1] = {.frame = {{-0.1, 2.0, 0.0}}};
             return Edits{add};
         },
         1, 0.0},
    };
}

/// How far a body is from a pose, metres and radians.
double movedFrom(const Pose& pose, const Pose& now) {
    const glm::dquat turn = glm::conjugate(pose.rotation) * now.rotation;
    return std::max(glm::length(now.position - pose.position), 2.0 * glm::length(glm::dvec3(turn.x, turn.y, turn.z)));
}

TEST(Wake, EachChangeThatCanMoveWhatSleepsWakesIt) {
    for (const auto& list :
         {changesOfShapes(), changesOfMaterials(), changesOfBodies(), changesOfSurroundings(), changesOfJoints()})
        for (const Change& change : list) {
            SCOPED_TRACE(change.name);
            PhysicsScene scene;
            change.build(scene);
            scene.load();
            scene.stepWith({});
            for (int i = 0; i < 60 * 20 && scene.physics.stats().awake > 0; ++i) scene.step();
            const BodyHandle body = scene.handle(change.body);
            EXPECT_TRUE(scene.world.bodies().at(body).asleep) << "before the change";
            const Pose before = scene.world.bodies().at(body).pose;
            scene.stepWith(change.edits(scene));
            double most = 0.0;
            for (int i = 0; i < 180; ++i) {
                scene.step();
                most = std::max(most, movedFrom(before, scene.world.bodies().at(body).pose));
            }
            EXPECT_GT(most, change.least);
        }
}

}  // namespace
}  // namespace rubble
