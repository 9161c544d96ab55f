#include "tests/physics/scenes/rope_scenes.h"

#include <algorithm>

#include "tests/physics/scenes/energy.h"
#include "tests/physics/scenes/joint_scenes.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/physics/scenes/load_scenes.h"

namespace rubble::known {
namespace {

constexpr double kRopeRadius = 0.03;
constexpr double kLift = 0.2;   ///< metres by which the chain starts above the beam, half of its spacing
constexpr double kBelow = 0.5;  ///< metres from the beam's upper side to the load's at the start

/// Places on a path of straight lines, each `spacing` metres along it from the last.
std::vector<RopePoint> pointsAlong(const std::vector<glm::dvec3>& path, double length, int count) {
    std::vector<RopePoint> points;
    for (int i = 0; i < count; ++i) {
        double left = length * i / (count - 1.0);
        size_t k = 0;
        while (k + 2 < path.size() && left > glm::length(path[k + 1] - path[k])) {
            left -= glm::length(path[k + 1] - path[k]);
            ++k;
        }
        points.push_back({path[k] + glm::normalize(path[k + 1] - path[k]) * left});
    }
    return points;
}

/// The metres by which a place is deeper in a square of half a side `half` about the z axis than its surface.
double depthIn(double half, glm::dvec3 place) {
    return half - std::max(std::abs(place.x), std::abs(place.y));
}

}  // namespace

BeamRope dropOverBeam(const PhysicsSettings& settings, const BeamDrop& drop) {
    PhysicsScene scene(sleepless(settings));
    const double half = 0.05 * drop.thickness, out = half + kRopeRadius;
    if (drop.seams) {
        LevelBody& beam = scene.add(solidGrid({drop.thickness, drop.thickness, 10}, 7), {-half, -half, -1.0}, true);
        beam.shapes.push_back(beam.shapes[0]);
        beam.shapes[1].name = "other half";
        beam.shapes[1].local.position.z = 1.0;
    } else
        scene.add(solidGrid({drop.thickness, drop.thickness, 20}, 7), {-half, -half, -1.0}, drop.spin == 0.0);
    const double top = half - kBelow;  // of the load, at the start
    const glm::dvec3 from(-half - drop.anchor, 0.0, 0.0), to(out, top, 0.0);
    scene.add(solidGrid({4, 4, 4}, entryOfMass(scene, drop.mass, 64)), to - glm::dvec3(0.2, 0.4, 0.2), false);
    const std::vector<glm::dvec3> path = {from, {-out, out, 0.0}, {out, out, 0.0}, to};
    double length = drop.drop;
    for (size_t i = 1; i < path.size(); ++i) length += glm::length(path[i] - path[i - 1]);
    const int points = std::max(3, int(std::lround(length / 0.4)) + 1);
    LevelJoint& rope = addJoint(scene, JointKind::Rope, "", "body 1", from, {0.2, 0.4, 0.2});
    rope.joint.rope.length = length;
    rope.joint.rope.points = uint32_t(points);
    rope.joint.rope.radius = kRopeRadius;
    // The slack is a loop to the side above the load. The chain starts above the beam, or it would cut it: a rope that
    // starts inside of something may come out on any side.
    const glm::dvec3 lift(0.0, kLift, 0.0), corner = path[2] + lift;
    rope.joint.points = pointsAlong(
        {from, path[1] + lift, corner, corner + glm::dvec3(0.5 * drop.drop, 0.0, 0.0), corner, to}, length, points);
    if (drop.spin != 0.0) {
        LevelJoint& axle = addJoint(scene, JointKind::Hinge, "", "body 0", {}, {half, half, 1.0});
        axle.joint.ends[0].frame = hingeAt({});
        axle.joint.ends[1].frame = {{half, half, 1.0}, hingeAt({}).rotation};
        axle.joint.motor = {MotorMode::Speed, drop.spin, 1e6};
    }
    scene.load();
    BeamRope result;
    EnergyRecord energy(scene.world, settings);
    const JointHandle handle = scene.world.joints().handleAt(0);
    for (int i = 0; i < scene.stepsIn(drop.seconds); ++i) {
        scene.step();
        energy.update(scene.world, scene.physics.stats().work);
        result.isOver = true;
        const std::vector<RopePoint>& now = scene.world.joints().at(handle).points;
        for (size_t k = 0; k + 1 < now.size(); ++k)
            for (int s = 0; s < 16; ++s) {
                const glm::dvec3 a = now[k].position, b = now[k + 1].position, place = a + (b - a) * (s / 16.0);
                if (drop.spin == 0.0) result.inside = std::max(result.inside, depthIn(half, place));
                const glm::dvec3 next = a + (b - a) * ((s + 1) / 16.0);
                if (place.x * next.x <= 0.0 && place.x != next.x && std::abs(place.z) < 1.0 && place.y > -2.0 * half)
                    result.isOver = result.isOver && place.y > 0.0;
            }
    }
    const Body& load = scene.body(1);
    result.below = top - drop.drop - load.pose.transformPoint({0.2, 0.4, 0.2}).y;
    result.gained = energy.excess();
    result.lost = energy.lost();
    return result;
}

}  // namespace rubble::known
