#include "tests/physics/scenes/joint_scenes.h"

#include "runtime/core/constants.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble::known {

Pose hingeAt(glm::dvec3 place) {
    return {place, glm::angleAxis(-0.5 * kPi, glm::dvec3(0, 1, 0))};
}

LevelJoint& addJoint(Level& level, JointKind kind, int first, int second, const Pose& frame) {
    LevelJoint joint{{.kind = kind}, {}};
    const std::array<int, 2> bodies = {first, second};
    for (size_t i = 0; i < 2; ++i) {
        joint.joint.ends[i].frame = frame;
        if (bodies[i] < 0) continue;
        const LevelBody& body = level.bodies[size_t(bodies[i])];
        joint.shapeNames[i] = body.shapes[0].name;
        const Pose pose = body.pose * body.shapes[0].local;
        joint.joint.ends[i].frame = {pose.inversePoint(frame.position), glm::conjugate(pose.rotation) * frame.rotation};
    }
    level.joints.push_back(joint);
    return level.joints.back();
}

namespace {

double apart(const World& world) {
    double most = 0.0;
    world.joints().forEach([&](JointHandle, const Joint& joint) {
        most = std::max(most, glm::length(jointToWorld(world, joint.ends[0]).position -
                                          jointToWorld(world, joint.ends[1]).position));
    });
    return most;
}

/// The angle of a body that hangs in the plane of x and y from straight down, radians.
double angleOf(const Body& body) {
    const glm::dvec3 down = body.pose.rotation * glm::dvec3(0.0, -1.0, 0.0);
    return std::atan2(down.x, -down.y);
}

void addBar(PhysicsScene& scene, double angle) {
    const glm::dquat turned = glm::angleAxis(angle, glm::dvec3(0, 0, 1));
    scene.add(solidGrid({1, 10, 1}, 7), turned * glm::dvec3(-0.05, -1.0, -0.05), false, turned);
    addJoint(scene.level, JointKind::Hinge, -1, 0, hingeAt({0, 0, 0}));
}

}  // namespace

Pendulum swing(const PhysicsSettings& settings, double degrees) {
    PhysicsScene scene(settings);
    const double amplitude = degrees * kPi / 180.0;
    addBar(scene, amplitude);
    scene.load();
    const MassProperties mass = bodyMass(scene.world, scene.handle(0));
    const double d = glm::length(scene.center(0));
    Pendulum result;
    const double moment = mass.inertia[2] + mass.mass * d * d;
    double a = 1.0,
           g = std::cos(0.5 * amplitude);  // the period is 1 / agm(1, cos(amplitude / 2)) times that of small swings
    for (int i = 0; i < 30; ++i) {
        const double mean = 0.5 * (a + g);
        g = std::sqrt(a * g);
        a = mean;
    }
    result.expected =
        2.0 * kPi * std::sqrt(moment / (mass.mass * -double(scene.world.environment().gravity.y) * d)) / a;
    std::vector<double> crossings;
    double last = angleOf(scene.body(0)), most = 0.0;
    for (int i = 1; i < 60 * 60 && crossings.size() < 21; ++i) {
        scene.step();
        const double now = angleOf(scene.body(0));
        if (last * now < 0.0) crossings.push_back((i - 1 + last / (last - now)) / 60.0);
        if (crossings.size() >= 20) most = std::max(most, std::abs(now));
        last = now;
    }
    result.period = (crossings.back() - crossings.front()) / (0.5 * double(crossings.size() - 1));
    result.kept = most / amplitude;
    return result;
}

double hitLimit(const PhysicsSettings& settings, double limit) {
    PhysicsScene scene(settings);
    addBar(scene, 0.0);
    LevelJoint& hinge = scene.level.joints.back();
    hinge.joint.limits = {true, -limit, limit};
    scene.level.bodies[0].angularVelocity = {0.0f, 0.0f, 6.0f};
    scene.level.bodies[0].velocity = {3.0f, 0.0f, 0.0f};
    scene.load();
    double beyond = 0.0;
    for (int i = 0; i < 600; ++i) {
        scene.step();
        beyond = std::max(beyond, std::abs(angleOf(scene.body(0))) - limit);
    }
    return beyond;
}

Motor turn(const PhysicsSettings& settings) {
    PhysicsScene scene(settings);
    scene.add(solidGrid({11, 1, 1}, 7), {-0.55, -0.05, -0.05}, false);
    LevelJoint& hinge = addJoint(scene.level, JointKind::Hinge, -1, 0, hingeAt({0, 0, 0}));
    hinge.joint.motor = {MotorMode::Speed, 5.0, 20.0};
    scene.load();
    Motor result;
    const double moment = bodyMass(scene.world, scene.handle(0)).inertia[2];
    result.expected = 20.0 / moment;
    const int steps = std::max(2, int(0.5 * 60.0 * 5.0 / result.expected));
    scene.step(steps);
    result.acceleration = scene.body(0).angularVelocity.z * 60.0 / steps;
    scene.seconds(4.0);
    result.speed = scene.body(0).angularVelocity.z;
    return result;
}

double missedBy(const PhysicsSettings& settings, JointKind kind, double length, double maxForce) {
    const bool lifts = kind == JointKind::Prismatic;
    PhysicsScene scene(settings);
    scene.add(solidGrid({int(std::lround(10.0 * length)), 5, 5}, 7), {-0.25, -0.25, -0.25}, false);
    Pose axis;
    axis.rotation =
        lifts ? glm::angleAxis(0.5 * kPi, glm::dvec3(0, 0, 1)) : glm::angleAxis(0.5 * kPi, glm::dvec3(0, 1, 0));
    LevelJoint& joint = addJoint(scene.level, kind, -1, 0, axis);
    joint.joint.motor = {MotorMode::Position, lifts ? 1.0 : 0.5, maxForce};
    scene.load();
    scene.seconds(4.0);
    const glm::dquat turned = scene.body(0).pose.rotation;
    return lifts ? scene.center(0).y - 1.0 : 2.0 * std::asin(std::abs(turned.z)) - 0.5;
}

double springPeriod(const PhysicsSettings& settings, double hertz) {
    PhysicsScene scene(sleepless(settings));
    scene.level.environment.gravity = {0, 0, 0};
    scene.add(solidGrid({3, 3, 3}, 7), {-0.15, -0.15, -0.15}, false);
    LevelJoint& slide = addJoint(scene.level, JointKind::Prismatic, -1, 0, {});
    slide.joint.spring = {hertz, 0.0};
    slide.joint.ends[0].frame.position.x = 0.3;  // its equilibrium
    scene.load();
    std::vector<double> crossings;
    double last = scene.center(0).x - 0.3;
    for (int i = 1; i < 3600 && crossings.size() < 11; ++i) {
        scene.step();
        const double now = scene.center(0).x - 0.3;
        if (last * now < 0.0) crossings.push_back((i - 1 + last / (last - now)) / 60.0);
        last = now;
    }
    return crossings.size() < 3 ? 0.0 : (crossings.back() - crossings.front()) / (0.5 * double(crossings.size() - 1));
}

double springKeeps(const PhysicsSettings& settings, double hertz, double dampingRatio) {
    PhysicsScene scene(sleepless(settings));
    scene.level.environment.gravity = {0, 0, 0};
    scene.add(solidGrid({3, 3, 3}, 7), {-0.15, -0.15, -0.15}, false);
    LevelJoint& slide = addJoint(scene.level, JointKind::Prismatic, -1, 0, {});
    slide.joint.spring = {hertz, dampingRatio};
    slide.joint.ends[0].frame.position.x = 0.3;  // its equilibrium
    scene.load();
    double most = 0.0;  // from the last time that it is in the middle before
    for (int i = 1; i <= std::max(int(60.0 * 3.25 / hertz), 100); ++i) {
        scene.step();
        if (i > 60.0 * 2.25 / hertz) most = std::max(most, std::abs(scene.center(0).x - 0.3));
    }
    return most / 0.3;
}

double breakFixed(const PhysicsSettings& settings, double force) {
    PhysicsScene scene(settings);
    scene.add(solidGrid({4, 4, 4}, 7), {0.0, 0.0, 0.0}, false);
    LevelJoint& joint = addJoint(scene.level, JointKind::Fixed, -1, 0, {{0.2, 0.4, 0.2}});
    joint.joint.breakForce = force;
    scene.load();
    const double weight = bodyMass(scene.world, scene.handle(0)).mass * 9.81;
    scene.seconds(1.0);
    for (int i = 0; i < 2000; ++i) {
        const double pull = force * i / 1000.0;
        FrameChanges changes;
        changes.impulses.push_back({scene.handle(0), scene.center(0), {0.0, -pull / 60.0, 0.0}});
        scene.physics.apply(changes, scene.world);
        scene.step();
        if (!scene.physics.jointBreaks().empty()) return (weight + pull) / force;
    }
    return 0.0;
}

Chain swingChain(const PhysicsSettings& settings, int links, double seconds) {
    PhysicsScene scene(settings);
    for (int i = 0; i < links; ++i) {
        scene.add(solidGrid({4, 1, 1}, 7), {0.4 * i, -0.05, -0.05}, false);
        addJoint(scene.level, JointKind::Ball, i - 1, i, {{0.4 * i, 0.0, 0.0}});
    }
    scene.load();
    Chain result;
    for (int i = 0; i < int(seconds * 60.0); ++i) {
        scene.step();
        result.worst = std::max(result.worst, apart(scene.world));
    }
    result.apart = apart(scene.world);
    return result;
}

double hangHeavy(const PhysicsSettings& settings, int links, double ratio) {
    PhysicsScene scene(sleepless(settings));
    for (int i = 0; i < links; ++i) {
        scene.add(solidGrid({1, 4, 1}, 7), {-0.05, -0.4 * (i + 1), -0.05}, false);
        addJoint(scene.level, JointKind::Ball, i - 1, i, {{0.0, -0.4 * i, 0.0}});
    }
    const uint32_t light = scene.level.materials.materials[7].density;
    const int side = 10;
    const uint8_t heavy = setMaterial(scene, 8, 0.5f, 0.0f, uint32_t(light * ratio * 4.0 / (side * side * side)));
    scene.add(solidGrid({side, side, side}, heavy), {-0.5, -0.4 * links - 1.0, -0.5}, false);
    addJoint(scene.level, JointKind::Ball, links - 1, links, {{0.0, -0.4 * links, 0.0}});
    scene.load();
    scene.seconds(10.0);
    return apart(scene.world);
}

RopeSwing swingOnRope(const PhysicsSettings& settings, double ratio) {
    PhysicsScene scene(settings);
    const double massOfPoint = 5.0 / 12.0;
    const uint8_t heavy = setMaterial(scene, 8, 0.5f, 0.0f, uint32_t(massOfPoint * ratio / 0.125));
    const double angle = 0.2;
    const glm::dvec3 low = {5.0 * std::sin(angle), 10.0 - 5.0 * std::cos(angle), 0.0};
    scene.add(solidGrid({5, 5, 5}, heavy), low - glm::dvec3(0.25, 0.5, 0.25), false);
    LevelJoint& rope = addJoint(scene.level, JointKind::Rope, -1, 0, {low});
    rope.joint.ends[0].frame = {{0.0, 10.0, 0.0}};
    rope.joint.rope.points = 13;
    scene.load();
    RopeSwing result;
    std::vector<double> crossings;
    double last = 1.0, length = 0.0;
    for (int i = 1; i < 60 * 30; ++i) {
        scene.step();
        const Joint& joint = scene.world.joints().at(scene.world.joints().handleAt(0));
        length = joint.rope.length;
        result.stretched = std::max(result.stretched, apart(scene.world) - length);
        double chain = 0.0;
        for (size_t k = 1; k < joint.points.size(); ++k)
            chain += glm::length(joint.points[k].position - joint.points[k - 1].position);
        result.longest = std::max(result.longest, chain - length);
        const double now = scene.center(0).x;
        if (last * now < 0.0) crossings.push_back((i - 1 + last / (last - now)) / 60.0);
        last = now;
    }
    result.period =
        crossings.size() < 3 ? 0.0 : (crossings.back() - crossings.front()) / (0.5 * double(crossings.size() - 1));
    // A double pendulum of the rope and the block below it, with the block's moment of inertia and the correction for
    // the amplitude.
    result.expected = 2.0 * kPi * std::sqrt((length + 0.25) / 9.81) * (1.0 + angle * angle / 16.0);
    return result;
}

Pulley hangOver(const PhysicsSettings& settings) {
    PhysicsScene scene(sleepless(settings));
    scene.add(solidGrid({2, 2, 20}, 7), {-0.1, 5.0, -1.0}, true);
    scene.add(solidGrid({4, 4, 4}, 7), {-0.55, 2.0, -0.2}, false);
    scene.add(solidGrid({4, 16, 4}, 7), {0.15, 2.0, -0.2}, false);
    LevelJoint& rope = addJoint(scene.level, JointKind::Rope, 1, 2, {});
    rope.joint.ends[0].frame = {{0.2, 0.4, 0.2}};
    rope.joint.ends[1].frame = {{0.2, 1.6, 0.2}};
    rope.joint.rope.points = 25;
    rope.joint.rope.length = 5.2;
    for (int i = 0; i < 25; ++i) {  // up, over the beam, and down
        const double along = 5.2 * i / 24.0;
        const glm::dvec3 place = along < 2.9   ? glm::dvec3(-0.35 + 0.15 * along / 2.9, 2.4 + along, 0.0)
                                 : along < 3.4 ? glm::dvec3(-0.2 + (along - 2.9), 5.3, 0.0)
                                               : glm::dvec3(0.3, 5.3 - (along - 3.4), 0.0);
        rope.joint.points.push_back({place});
    }
    scene.load();
    const double from = scene.center(1).y;
    Pulley result;
    for (int i = 0; i < 90; ++i) {
        scene.step();
        result.risen = scene.center(1).y - from;
        if (result.risen > 2.0) break;  // before it is pulled over the beam
        for (const RopePoint& point : scene.world.joints().at(scene.world.joints().handleAt(0)).points)
            if (std::abs(point.position.z) < 1.0)
                result.sunk = std::max(result.sunk, std::min({0.1 - std::abs(point.position.x), 5.2 - point.position.y,
                                                              point.position.y - 5.0}));
    }
    return result;
}

}  // namespace rubble::known
