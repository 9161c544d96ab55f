#include "tests/physics/scenes/impact_scenes.h"

#include <algorithm>
#include <cmath>

#include "physics/shapes/voxel_collider.h"
#include "runtime/core/constants.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble::known {

bool staysInShaft(const PhysicsSettings& settings, const ShaftShot& shot) {
    PhysicsScene scene(sleepless(settings));
    const int inside = shot.isSnug ? shot.size : shot.size + 3, length = 40;
    const glm::ivec3 all(inside + 4, length + shot.end, inside + 4);
    const auto isOpen = [&](glm::ivec3 c) {
        return c.y >= shot.end && c.x >= 2 && c.x < inside + 2 && c.z >= 2 && c.z < inside + 2;
    };
    scene.add(gridOf(all, [&](glm::ivec3 c) { return uint8_t(isOpen(c) ? 0 : 7); }), {0, 0, 0}, true);
    LevelBody& crate = scene.add(solidGrid(glm::ivec3(shot.size), 7), {0.2, 0.1 * shot.end + 2.0, 0.2}, false);
    crate.velocity = {0.0f, -float(shot.speed), 0.0f};
    scene.load();
    scene.step(40);
    return scene.center(1).y > 0.1 * shot.end;
}

LedgeHit landOnLedge(const PhysicsSettings& settings, double speed, double share) {
    PhysicsScene scene(sleepless(settings));
    scene.level.environment.gravity = {0, 0, 0};
    const uint8_t entry = setMaterial(scene, 7, 0.0f, 0.0f);
    scene.add(solidGrid({10, 10, 20}, entry), {-1.0, -1.0, -1.0}, true);
    LevelBody& plank = scene.add(solidGrid({20, 1, 4}, entry), {-2.0 * share, 0.95 * speed / 60.0, -0.2}, false);
    plank.velocity = {0.0f, -float(speed), 0.0f};
    scene.load();
    LedgeHit hit;
    for (int i = 0; i < 6 && hit.spin == 0.0; ++i) {
        scene.step();
        hit.spin = double(scene.body(1).angularVelocity.z);
    }
    hit.speed = -double(scene.body(1).velocity.y);
    const double d = 1.0 - 2.0 * share;
    hit.expectedSpin = -speed * d / ((4.0 + 0.01) / 12.0 + d * d);
    hit.expectedSpeed = -hit.expectedSpin * d;
    return hit;
}

ObliqueBounce bounceAslant(const PhysicsSettings& settings, double friction, double restitution) {
    PhysicsScene scene(sleepless(settings));
    scene.level.environment.gravity = {0, 0, 0};
    const uint8_t entry = setMaterial(scene, 7, float(friction), float(restitution));
    scene.add(solidGrid({80, 4, 40}, entry), {-2.0, -0.4, -2.0}, true);
    scene.add(solidGrid({14, 2, 14}, entry), {-1.5, 0.2, -0.7}, false).velocity = {8.0f, -4.0f, 0.0f};
    scene.load();
    scene.step(12);
    const glm::dvec3 v(scene.body(1).velocity);
    return {v.y, 4.0 * restitution, 8.0 - v.x, friction * (1.0 + restitution) * 4.0};
}

VoxelGrid ball(int across, uint8_t entry) {
    return gridOf(glm::ivec3(across), [&](glm::ivec3 c) {
        const glm::ivec3 d = 2 * c + 1 - across;
        return uint8_t(d.x * d.x + d.y * d.y + d.z * d.z <= across * across ? entry : 0);
    });
}

void addCradle(PhysicsScene& scene, bool areBalls, int incoming, double speed, float restitution) {
    scene.level.environment.gravity = {0, 0, 0};
    const uint8_t entry = setMaterial(scene, 7, 0.0f, restitution);
    const VoxelGrid grid = areBalls ? ball(8, entry) : solidGrid({8, 8, 8}, entry);
    const std::optional<RoundSurface> fit = fitRoundSurface(grid, {glm::ivec3(0), grid.size()}, CollisionShape::Sphere);
    const double apart = areBalls ? 0.2 * double(fit->radius) : 0.8;
    for (int i = 0; i < kCradleBodies; ++i) {
        const bool isIncoming = i < incoming;
        LevelBody& body = scene.add(grid, {i * apart - (isIncoming ? 0.23 : 0.0), 0, 0}, false);
        if (isIncoming) body.velocity = {float(speed), 0, 0};
        if (areBalls) body.shapes[0].collisionShape = CollisionShape::Sphere;
    }
    scene.load();
}

double cradleError(const PhysicsSettings& settings, bool areBalls, int incoming, double speed) {
    PhysicsScene scene(sleepless(settings));
    addCradle(scene, areBalls, incoming, speed);
    scene.step(20 + int(0.23 / speed * 60.0));
    double worst = 0.0;
    for (int i = 0; i < kCradleBodies; ++i) {
        const double expected = i < kCradleBodies - incoming ? 0.0 : speed;
        worst = std::max(worst, std::abs(double(scene.body(i).velocity.x) - expected) / speed);
    }
    return worst;
}

namespace {

double kineticEnergy(const PhysicsScene& scene) {
    double sum = 0.0;
    for (int i = 0; i < int(scene.level.bodies.size()); ++i) {
        const Body& body = scene.body(i);
        if (body.isStatic) continue;
        const MassProperties mass = bodyMass(scene.world, scene.handle(i));
        const glm::dvec3 v(body.velocity),
            w = glm::conjugate(body.pose.rotation * mass.principalAxes) * glm::dvec3(body.angularVelocity);
        sum += 0.5 * (mass.mass * glm::dot(v, v) + glm::dot(w, mass.principalInertia * w));
    }
    return sum;
}

/// A blade (body 0) and a post (body 1). hub: the axis, in the blade.
void addBlade(PhysicsScene& scene, const Blade& blade, const glm::dvec3& hub) {
    scene.level.environment.gravity = {0, 0, 0};
    const double half = 0.05 * blade.thickness, side = 0.1 * blade.post;
    LevelBody& body = scene.add(solidGrid({80, blade.thickness, blade.thickness}, 7), -hub, false);
    body.angularVelocity = {0.0f, float(blade.spin), 0.0f};
    body.velocity = glm::vec3(glm::cross(glm::dvec3(body.angularVelocity), glm::dvec3(4.0, half, half) - hub));
    const glm::dvec3 place(blade.at * std::cos(blade.angle), 0.0, -blade.at * std::sin(blade.angle));
    scene.add(solidGrid({blade.post, 20, blade.post}, 7), place - glm::dvec3(0.5 * side, 1.0, 0.5 * side),
              blade.isPostStatic);
    if (!blade.isHinged) return;
    LevelJoint joint{{.kind = JointKind::Hinge}, {scene.level.bodies[0].shapes[0].name, ""}};
    const glm::dquat up = glm::angleAxis(0.5 * kPi, glm::dvec3(0, 0, 1));  // x to y
    joint.joint.ends[0].frame = {hub, up};
    joint.joint.ends[1].frame = {{0, 0, 0}, up};
    if (blade.hasMotor) joint.joint.motor = {MotorMode::Speed, -blade.spin, 1e6};
    scene.level.joints.push_back(joint);
}

}  // namespace

BladeHit spinBlade(const PhysicsSettings& settings, const Blade& blade) {
    PhysicsScene scene(sleepless(settings));
    const double half = 0.05 * blade.thickness;
    const glm::dvec3 hub(blade.isAtItsEnd ? 0.05 : 4.0, half, half);
    addBlade(scene, blade, hub);
    scene.load();
    const double before = kineticEnergy(scene);
    // The angle from the blade to the post about y, as the blade sees it from its hub.
    const auto angleNow = [&] {
        const Pose& pose = scene.body(0).pose;
        const glm::dvec3 along = pose.rotation * glm::dvec3(1, 0, 0), to = scene.center(1) - pose.transformPoint(hub);
        return std::atan2(glm::cross(along, to).y, along.x * to.x + along.z * to.z);
    };
    BladeHit hit;
    const double arms = blade.isAtItsEnd ? 2.0 * kPi : kPi;  // from one arm to the next
    const int turn = int(std::ceil(2.0 * kPi / blade.spin * 60.0)) + 1;
    double angle = angleNow();
    for (int i = 0; i < turn && !hit.isHit; ++i) {
        scene.step();
        hit.isHit = std::abs(double(scene.body(0).angularVelocity.y) / blade.spin - 1.0) > 1e-3 ||
                    glm::length(scene.body(1).velocity) > 0.0f;
        const double now = angle + std::remainder(angleNow() - angle, 2.0 * kPi);
        const double away = glm::length(scene.center(1) - scene.body(0).pose.transformPoint(hub));
        const bool isInReach = away < (blade.isAtItsEnd ? 8.0 : 4.0);  // not flung out of it
        hit.passed = hit.passed || (isInReach && std::floor(now / arms) != std::floor(angle / arms));
        angle = now;
    }
    hit.energy = kineticEnergy(scene) / before;
    return hit;
}

namespace {

/// The mean distance of the cells of a grid's lowest layer from its middle, cells.
double meanRadius(const VoxelGrid& grid) {
    double sum = 0.0;
    int count = 0;
    const glm::dvec2 middle = glm::dvec2(grid.size().x, grid.size().z) * 0.5;
    for (int x = 0; x < grid.size().x; ++x)
        for (int z = 0; z < grid.size().z; ++z) {
            if (!grid.at({x, 0, z})) continue;
            for (int i = 0; i < 16; ++i)  // the parts of a cell
                sum += glm::length(glm::dvec2(x + (i % 4 + 0.5) / 4.0, z + (i / 4 + 0.5) / 4.0) - middle) / 16.0;
            ++count;
        }
    return sum / count;
}

}  // namespace

SpinDown spinDown(const PhysicsSettings& settings, const VoxelGrid& grid, double spin) {
    PhysicsScene scene(sleepless(settings));
    setMaterial(scene, 7, 0.4f, 0.0f);
    scene.addFloor(7);
    const glm::dvec3 half = glm::dvec3(grid.size()) * 0.05;
    scene.add(grid, {-half.x, 0.0, -half.z}, false).angularVelocity = {0.0f, float(spin), 0.0f};
    scene.load();
    const MassProperties mass = bodyMass(scene.world, scene.handle(1));
    const double loss = 0.4 * 9.81 * mass.mass * 0.1 * meanRadius(grid) / mass.inertia[1];  // rad/s in a second
    const int steps = std::max(1, int(0.6 * spin / loss * 60.0));
    scene.step(steps);
    return {spin - double(scene.body(1).angularVelocity.y), loss * steps / 60.0};
}

std::vector<std::pair<const char*, VoxelGrid>> spinDownGrids() {
    const auto disc = [](glm::ivec3 c) {
        const int x = 2 * c.x - 19, z = 2 * c.z - 19;
        return uint8_t(x * x + z * z <= 400 ? 7 : 0);
    };
    const auto ring = [&](glm::ivec3 c) {
        const int x = 2 * c.x - 19, z = 2 * c.z - 19;
        return uint8_t(x * x + z * z > 196 ? disc(c) : 0);
    };
    const auto table = [](glm::ivec3 c) {
        const bool isFoot = (c.x < 3 || c.x > 16) && (c.z < 3 || c.z > 16);
        return uint8_t(c.y > 0 || isFoot ? 7 : 0);
    };
    return {
        {"disc", gridOf({20, 2, 20}, disc)},   {"ring", gridOf({20, 2, 20}, ring)},
        {"square", solidGrid({10, 2, 10}, 7)}, {"bar", solidGrid({24, 2, 4}, 7)},
        {"table", gridOf({20, 2, 20}, table)},
    };
}

}  // namespace rubble::known
