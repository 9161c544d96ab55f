#include <gtest/gtest.h>

#include <glm/common.hpp>

#include "tests/physics/scenes/energy.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/load_scenes.h"
#include "tests/physics/scenes/rope_scenes.h"

namespace rubble {
namespace {

std::string nameOf(const known::BeamDrop& drop) {
    return std::to_string(drop.thickness) + " voxels, " + std::to_string(drop.mass) + " kg from " +
           std::to_string(drop.drop) + " m, end at " + std::to_string(drop.anchor) + " m, " +
           std::to_string(drop.seams) + " seams, " + std::to_string(drop.spin) + " rad/s";
}

/// The chain has a point every 0.4 m: it goes round a beam to half of that, and the rope's thickness. The farthest,
/// 0.202 m, is that whose end is held at the beam.
void expectStaysOver(const known::BeamDrop& drop) {
    const known::BeamRope rope = known::dropOverBeam({}, drop);
    EXPECT_TRUE(rope.isOver) << nameOf(drop);
    EXPECT_LT(rope.inside, 0.05) << nameOf(drop);
    EXPECT_LT(std::abs(rope.below), drop.spin == 0.0 ? 0.21 : 0.25) << nameOf(drop);
    EXPECT_LT(rope.gained, 1e-3 * rope.lost + 0.01) << nameOf(drop);
}

TEST(Rope, IsNotPulledThroughAThinBeam) {
    for (const int thickness : {1, 2, 3, 4})
        for (const double mass : {1.0, 100.0, 1000.0})
            for (const double drop : {0.0, 1.0, 5.0, 20.0})
                expectStaysOver({.thickness = thickness, .mass = mass, .drop = drop});
}

TEST(Rope, WindsOnWhatIsNextToAHeldEnd) {
    for (const int thickness : {2, 4})
        for (const double anchor : {0.0, 0.05, 0.1, 0.2, 0.3, 0.5})
            expectStaysOver({.thickness = thickness, .anchor = anchor});
}

TEST(Rope, LiesOnASeamAndOnWhatTurns) {
    for (const int thickness : {1, 2, 4}) {
        expectStaysOver({.thickness = thickness, .seams = 1});
        expectStaysOver({.thickness = thickness, .drop = 0.0, .spin = 2.0});
    }
}

/// A block that hangs from a rope whose end is under it, inside it or near its top.
TEST(Rope, GoesRoundTheBodyAtItsEndWithoutGainingEnergy) {
    for (const double depth : {0.0, 0.25, 0.4}) {
        PhysicsScene scene(known::sleepless({}));
        scene.add(solidGrid({5, 5, 5}, known::entryOfMass(scene, 100.0, 125)), {1.0, -2.0, -0.25}, false);
        known::addJoint(scene, JointKind::Rope, "", "body 0", {}, {0.25, depth, 0.25}).joint.ends[1].radius = 0.5;
        scene.load();
        known::EnergyRecord energy(scene.world, {});
        for (int i = 0; i < 1200; ++i) {
            scene.step();
            energy.update(scene.world);
        }
        EXPECT_LT(energy.excess(), 2e-3 * energy.lost()) << depth;
    }
}

/// Metres of a rope's chain of points.
double chainLength(const Joint& rope) {
    double length = 0.0;
    for (size_t i = 1; i < rope.points.size(); ++i)
        length += glm::distance(rope.points[i].position, rope.points[i - 1].position);
    return length;
}

constexpr double kCube = 0.4;  ///< metres that a cube at the end of a rope is wide

/// Whether a rope's chain passes between two cubes that leave it no room: it is within `reach` metres of both.
bool isSqueezed(const Joint& rope, const Pose& first, const Pose& second, double reach) {
    const auto isNear = [&](const Pose& cube, glm::dvec3 place) {
        const glm::dvec3 local = cube.inversePoint(place);
        return glm::distance(local, glm::clamp(local, glm::dvec3(0.0), glm::dvec3(kCube))) < reach;
    };
    for (size_t i = 1; i < rope.points.size(); ++i)
        for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const glm::dvec3 place = glm::mix(rope.points[i - 1].position, rope.points[i].position, part);
            if (isNear(first, place) && isNear(second, place)) return true;
        }
    return false;
}

/// A rope from a static cube to one that hangs below it, level with it or aslant, with both ends `depth` metres inside.
/// points: of the chain, 0 for the default. A chain goes round corners to half of the space between its points.
void expectStaysInItsHoles(glm::dvec3 way, double radius, double depth, double voxelSize, uint32_t points) {
    PhysicsScene scene(known::sleepless({}));
    const int n = int(std::lround(kCube / voxelSize));
    scene.add(solidGrid(glm::ivec3(n), 7), {0, 0, 0}, true).shapes[0].voxelSize = float(voxelSize);
    scene.add(solidGrid(glm::ivec3(n), 7), way * 1.4, false).shapes[0].voxelSize = float(voxelSize);
    const glm::dvec3 first = glm::dvec3(0.2) + way * (0.2 - depth), second = glm::dvec3(0.2) - way * (0.2 - depth);
    RopeSettings& rope = known::addJoint(scene, JointKind::Rope, "body 0", "body 1", first, second).joint.rope;
    rope.radius = radius;
    rope.points = points;
    scene.load();
    double longest = 0.0;
    int squeezed = 0;
    known::EnergyRecord energy(scene.world, {});
    for (int i = 0; i < 300; ++i) {
        scene.step();
        energy.update(scene.world);
        const Joint& joint = scene.world.joints().at(scene.world.joints().handleAt(0));
        if (isSqueezed(joint, scene.body(0).pose, scene.body(1).pose, radius + 0.04))
            ++squeezed;
        else
            longest = std::max(longest, chainLength(joint) / joint.rope.length);
    }
    const double spacing = 1.0 / double(scene.world.joints().at(scene.world.joints().handleAt(0)).points.size() - 1);
    EXPECT_LT(squeezed, 40);
    EXPECT_LT(longest, 1.03 + 0.5 * radius + (way.y == -1.0 ? 0.0 : 0.5 * spacing))
        << way.x << ", radius " << radius << ", " << depth << " m deep, voxels " << voxelSize << ", points " << points;
    EXPECT_LT(energy.excess(), 2e-3 * energy.lost() + 0.1)
        << way.x << ", radius " << radius << ", depth " << depth << ", voxels " << voxelSize << ", points " << points;
}

TEST(Rope, WithEndsInsideOfItsShapesIsNotThrownOut) {
    for (const double radius : {0.01, 0.03, 0.06})
        for (const double depth : {0.0, 0.02, 0.05, 0.1, 0.2})
            for (const double voxelSize : {0.05, 0.1})
                for (const glm::dvec3& way : {glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0.6, -0.8, 0)})
                    for (const uint32_t points : {0u, 17u, 33u})
                        expectStaysInItsHoles(way, radius, depth, voxelSize, points);
}

/// What a rope knew of the time that was undone does not act on the past.
TEST(Rope, SwingsOnAfterAnUndoAsBefore) {
    for (const int undone : {1, 20, 60}) {
        PhysicsScene scene(known::sleepless({}));
        scene.add(solidGrid({4, 4, 4}, 7), {3.0, -0.2, -0.2}, false).velocity = {0.0f, 1.0f, 2.0f};
        known::addJoint(scene, JointKind::Rope, "", "body 0", {}, {0.0, 0.2, 0.2});
        scene.load();
        WorldSettings settings = scene.world.settings();
        settings.undoMarks = 1;
        scene.stepWith({SettingsEdit{settings}});
        scene.step(40);
        const auto places = [&](HistoryAction action, int steps) {
            std::vector<glm::dvec3> found;
            for (int i = 0; i < steps; ++i) {
                scene.stepWith(i == 0 ? Edits{HistoryEdit{action}} : Edits{});
                found.push_back(scene.center(0));
                const std::vector<RopePoint>& points = scene.world.joints().at(scene.world.joints().handleAt(0)).points;
                found.push_back(points[points.size() / 2].position);
            }
            return found;
        };
        const std::vector<glm::dvec3> first = places(HistoryAction::Mark, undone);
        const std::vector<glm::dvec3> again = places(HistoryAction::Undo, undone);
        double apart = 0.0;
        for (size_t i = 0; i < first.size(); ++i) apart = std::max(apart, glm::distance(first[i], again[i]));
        EXPECT_LT(apart, 1e-3) << "undone after " << undone << " steps";
    }
}

}  // namespace
}  // namespace rubble
