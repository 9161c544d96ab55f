#include "tests/physics/scenes/known_scenes.h"

#include "runtime/core/random.h"
#include "tests/physics/baseline/overlap.h"

namespace rubble::known {

uint8_t setMaterial(PhysicsScene& scene, uint8_t entry, float friction, float restitution, uint32_t density) {
    Material& material = scene.level.materials.materials[entry];
    material.friction = friction;
    material.restitution = restitution;
    material.density = density;
    return entry;
}

PhysicsSettings sleepless(PhysicsSettings settings) {
    settings.sleepTime = 1e9;
    return settings;
}

VoxelGrid tHandle() {
    VoxelGrid grid({11, 6, 1});
    GridWriter writer(grid);
    for (int x = 0; x < 11; ++x) writer.set({x, 0, 0}, 7);
    for (int y = 1; y < 6; ++y) writer.set({5, y, 0}, 7);
    return grid;
}

namespace {

/// Follows momentum, energy and flips of a body.
class SpinWatch {
public:
    SpinWatch(glm::dvec3 inertia, FreeSpin& result) : m_inertia(inertia), m_result(result) {
        m_middle = 0;
        for (int i = 0; i < 3; ++i)
            if ((inertia[i] > inertia[(i + 1) % 3]) != (inertia[i] > inertia[(i + 2) % 3])) m_middle = i;
    }
    /// w: in principal axes.
    void see(double time, const glm::dquat& rotation, glm::dvec3 w) {
        const glm::dvec3 L = rotation * (m_inertia * w);
        const double energy = 0.5 * glm::dot(w, m_inertia * w);
        if (!m_seen) m_L = L, m_energy = energy, m_seen = true;
        m_result.momentum = std::max(m_result.momentum, std::abs(glm::length(L) / glm::length(m_L) - 1.0));
        m_result.direction = std::max(m_result.direction, glm::length(glm::cross(L, m_L)) / glm::dot(m_L, m_L));
        m_result.energy = std::max(m_result.energy, std::abs(energy / m_energy - 1.0));
        if (w[m_middle] * m_last < 0) m_result.flips.push_back(time);
        m_last = w[m_middle];
        m_result.rotation = rotation;
    }

private:
    glm::dvec3 m_inertia, m_L{0.0};
    FreeSpin& m_result;
    int m_middle;
    double m_energy = 0.0, m_last = 0.0;
    bool m_seen = false;
};

/// Steps, and says whether a body's centre went down through the plane at `height` within `halfWidth` metres of the
/// origin: not around the edge of what is there.
bool crosses(PhysicsScene& scene, int body, double height, double halfWidth) {
    const glm::dvec3 a = scene.center(body);
    scene.step();
    const glm::dvec3 b = scene.center(body);
    if (!(a.y > height && b.y <= height)) return false;
    const glm::dvec3 at = a + (b - a) * ((a.y - height) / (a.y - b.y));
    return std::max(std::abs(at.x), std::abs(at.z)) < halfWidth;
}

}  // namespace

FreeSpin spinFreely(const PhysicsSettings& settings, VoxelGrid grid, glm::dvec3 angularVelocity, double seconds) {
    PhysicsScene scene(sleepless(settings));
    scene.level.environment.gravity = {0, 0, 0};
    scene.add(std::move(grid), {0, 0, 0}, false).angularVelocity = angularVelocity;
    scene.load();
    const MassProperties mass = bodyMass(scene.world, scene.handle(0));
    FreeSpin result;
    SpinWatch watch(mass.principalInertia, result);
    for (int i = 0; i <= int(seconds * 60.0); ++i) {
        const Body& body = scene.body(0);
        const glm::dquat axes = body.pose.rotation * mass.principalAxes;
        watch.see(i / 60.0, axes, glm::conjugate(axes) * glm::dvec3(body.angularVelocity));
        scene.step();
    }
    return result;
}

FreeSpin spinBy(const SpinStep& step, glm::dvec3 inertia, glm::dvec3 w, double seconds) {
    FreeSpin result;
    SpinWatch watch(inertia, result);
    glm::dquat rotation(1, 0, 0, 0);
    for (int i = 0; i <= int(seconds * 60.0); ++i) {
        watch.see(i / 60.0, rotation, w);
        step(rotation, w);
    }
    return result;
}

SpinStep rungeKutta(glm::dvec3 inertia, int substeps) {
    return [inertia, substeps](glm::dquat& q, glm::dvec3& w) {
        const double h = 1.0 / 60.0 / substeps;
        const auto alpha = [&](glm::dvec3 v) { return glm::cross(inertia * v, v) / inertia; };
        const auto spin = [](const glm::dquat& r, glm::dvec3 v) { return r * glm::dquat(0.0, v.x, v.y, v.z) * 0.5; };
        for (int k = 0; k < substeps; ++k) {
            const glm::dvec3 a1 = alpha(w), a2 = alpha(w + a1 * (h / 2)), a3 = alpha(w + a2 * (h / 2)),
                             a4 = alpha(w + a3 * h);
            const glm::dquat q1 = spin(q, w), q2 = spin(q + q1 * (h / 2), w + a1 * (h / 2)),
                             q3 = spin(q + q2 * (h / 2), w + a2 * (h / 2)), q4 = spin(q + q3 * h, w + a3 * h);
            w += (a1 + a2 * 2.0 + a3 * 2.0 + a4) * (h / 6);
            q = glm::normalize(q + (q1 + q2 * 2.0 + q3 * 2.0 + q4) * (h / 6));
        }
    };
}

FreeSpin spinReference(glm::dvec3 inertia, glm::dvec3 w, double seconds, int substeps) {
    return spinBy(rungeKutta(inertia, substeps), inertia, w, seconds);
}

Slide slideDown(const PhysicsSettings& settings, double degrees, double heading, double friction, double seconds) {
    PhysicsScene scene(sleepless(settings));
    const uint8_t entry = setMaterial(scene, 7, float(friction), 0.0f);
    const glm::dvec3 up(0, 1, 0);
    // The plane is rotated under the block, so that its cells are not aligned with the slope either.
    const glm::dquat tilt = glm::angleAxis(glm::radians(degrees), glm::dvec3(0, 0, 1)),
                     turn = glm::angleAxis(heading, up);
    const glm::dquat plane = tilt * glm::angleAxis(0.37 * heading, up), block = tilt * turn;
    static const VoxelGrid ground = solidGrid({600, 5, 600}, 7);
    scene.add(ground, plane * glm::dvec3(-30, -0.5, -30), true, plane);
    scene.add(solidGrid({10, 3, 8}, entry), tilt * glm::dvec3(20, 0, 0) + block * glm::dvec3(-0.5, 0, -0.4), false,
              block);
    scene.load();
    std::vector<glm::dvec3> at;
    const int steps = scene.stepsIn(seconds);
    const double h = scene.stepSeconds;
    for (int i = 0; i <= steps; ++i, scene.step()) at.push_back(scene.center(1));
    const auto speed = [&](int i) { return glm::length(at[size_t(i)] - at[size_t(i - 1)]) / h; };
    return {glm::length(at[size_t(steps)] - at[size_t(steps - scene.stepsIn(1.0))]),
            (speed(steps) - speed(steps / 2)) / ((steps - steps / 2) * h)};
}

Tower stack(const PhysicsSettings& settings, int cubes, double seconds) {
    PhysicsScene scene(settings);
    scene.addFloor();
    for (int i = 0; i < cubes; ++i) scene.add(solidGrid({5, 5, 5}, 7), {0, 0.5 * i, 0}, false);
    scene.load();
    scene.seconds(seconds);
    Tower tower;
    tower.lower = 0.5 * cubes - 0.25 - scene.center(cubes).y;
    for (int i = 1; i <= cubes; ++i) {
        const glm::dvec3 c = scene.center(i);
        tower.aside = std::max({tower.aside, std::abs(c.x - 0.25), std::abs(c.z - 0.25)});
        tower.fastest = std::max(tower.fastest, double(glm::length(scene.body(i).velocity)));
    }
    tower.awake = scene.physics.stats().awake;
    return tower;
}

double farthestInStack(const PhysicsSettings& settings, double voxelSize, int cubes) {
    PhysicsScene scene(settings);
    const auto add = [&](glm::ivec3 size, glm::dvec3 corner, bool isStatic) {
        scene.add(solidGrid(size, 7), corner * voxelSize, isStatic).shapes[0].voxelSize = float(voxelSize);
    };
    add({100, 3, 100}, {-50, -3, -50}, true);
    for (int i = 0; i < cubes; ++i) add({4, 4, 4}, {0, 4 * i, 0}, false);
    scene.load();
    scene.seconds(10.0);
    double farthest = 0.0;
    for (int i = 0; i < cubes; ++i) {
        const glm::dvec3 place = voxelSize * glm::dvec3(2.0, 4.0 * i + 2.0, 2.0);
        farthest = std::max(farthest, glm::length(scene.center(i + 1) - place) / voxelSize);
    }
    return farthest;
}

double sink(const PhysicsSettings& settings, double ratio) {
    PhysicsScene scene(sleepless(settings));
    const uint8_t light = setMaterial(scene, 7, 0.6f, 0.0f, 10),
                  heavy = setMaterial(scene, 8, 0.6f, 0.0f, uint32_t(10.0 * ratio));
    scene.addFloor(light);
    scene.add(solidGrid({5, 5, 5}, light), {0, 0, 0}, false);
    scene.add(solidGrid({5, 5, 5}, heavy), {0, 0.5, 0}, false);
    scene.load();
    double deepest = 0.0;
    for (int i = scene.stepsIn(10.0); i > 0; --i) {
        scene.step();
        deepest = std::max(deepest, 0.75 - scene.center(2).y);
    }
    return deepest;
}

double unrest(const PhysicsSettings& settings, double voxelSize, glm::ivec3 size, double gravity) {
    PhysicsScene scene(sleepless(settings));
    scene.level.environment.gravity = {0.0f, -float(gravity), 0.0f};
    scene.addFloor();
    if (voxelSize > 0.1) {  // large bodies need a large floor
        scene.level.bodies[0].pose.position *= voxelSize / 0.1;
        scene.level.bodies[0].shapes[0].voxelSize = float(voxelSize);
    }
    const int longest = std::max(size.x, size.z);
    for (int i = 0; i < 9; ++i) {
        LevelBody& body =
            scene.add(solidGrid(size, 7),
                      {(i % 3 - 1.5) * voxelSize * (longest + 2.3), voxelSize * (0.5 + 0.06 * longest),
                       (i / 3 - 1.5) * voxelSize * (longest + 2.7)},
                      false, glm::angleAxis(0.1 * i, glm::normalize(glm::dvec3(0.1 * (i % 2), 1, 0.05 * (i % 3)))));
        body.shapes[0].voxelSize = float(voxelSize);
    }
    scene.load();
    scene.seconds(6.0 * std::max(1.0, std::sqrt(voxelSize * 9.81 / gravity)));  // large bodies take longer
    double fastest = 0.0;
    for (int i = 0; i < 60; ++i) {
        scene.step();
        for (int k = 1; k <= 9; ++k) fastest = std::max(fastest, double(glm::length(scene.body(k).velocity)));
    }
    return fastest;
}

Shots shoot(const PhysicsSettings& settings, int count, uint64_t seed, double fastest, double slowest, int thickness) {
    Random random(seed);
    Shots shots;
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (double(random.below(1u << 30)) / double(1u << 30));
    };
    const VoxelGrid wall = solidGrid({28, thickness, 28}, 7);
    for (; shots.fired < count; ++shots.fired) {
        PhysicsScene scene(sleepless(settings));
        scene.level.environment.gravity = {0, 0, 0};
        scene.add(wall, {-1.4, -0.1 * thickness + 0.05, -1.4}, true);
        const double speed = uniform(slowest, fastest), lean = uniform(0.0, 1.3), heading = uniform(0.0, 6.28),
                     distance = uniform(1.0, 2.0);
        const glm::dvec3 from(std::sin(lean) * std::cos(heading), std::cos(lean), std::sin(lean) * std::sin(heading));
        const int size = 1 + int(random.below(4));
        const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
        const glm::dquat turn = glm::normalize(glm::dquat(uniform(-1, 1), x, y, z));
        const glm::dvec3 start = from * std::max(distance, 0.5 / from.y);
        LevelBody& shot =
            scene.add(solidGrid(glm::ivec3(size), 7), start - turn * glm::dvec3(0.05 * size), false, turn);
        shot.velocity = from * -speed;
        const double wx = uniform(-30, 30), wy = uniform(-30, 30), wz = uniform(-30, 30);
        shot.angularVelocity = {wx, wy, wz};
        scene.load();
        bool through = false;
        for (int step = 0; step < int(glm::length(start) / speed * 60.0) + 4; ++step)
            through = crosses(scene, 1, 0.05 - 0.05 * thickness, 1.4) || through;
        shots.through += through;
    }
    return shots;
}

Shots shootPairs(const PhysicsSettings& settings, int count, uint64_t seed, double fastest, double late) {
    Random random(seed);
    Shots shots;
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (double(random.below(1u << 30)) / double(1u << 30));
    };
    const VoxelGrid wall = solidGrid({64, 1, 64}, 7);
    for (; shots.fired < count; ++shots.fired) {
        PhysicsScene scene(sleepless(settings));
        scene.level.environment.gravity = {0, 0, 0};
        scene.add(wall, {-3.2, -0.05, -3.2}, true);
        const double soon = uniform(0.02, 0.06);
        for (const int i : {0, 1}) {
            const double speed = uniform(10.0, fastest), lean = uniform(0.0, 1.3), heading = uniform(0.0, 6.28);
            const glm::dvec3 from(std::sin(lean) * std::cos(heading), std::cos(lean),
                                  std::sin(lean) * std::sin(heading));
            const int size = 1 + int(random.below(4));
            const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
            const glm::dquat turn = glm::normalize(glm::dquat(uniform(-1, 1), x, y, z));
            const glm::dvec3 start = from * std::max(speed * (soon + (i ? uniform(0.0, late) : 0.0)), 0.5 / from.y);
            LevelBody& shot =
                scene.add(solidGrid(glm::ivec3(size), 7), start - turn * glm::dvec3(0.05 * size), false, turn);
            shot.velocity = from * -speed;
            const double wx = uniform(-30, 30), wy = uniform(-30, 30), wz = uniform(-30, 30);
            shot.angularVelocity = {wx, wy, wz};
        }
        scene.load();
        bool through = false;
        for (int step = 0; step < 10; ++step) {
            const std::array<glm::dvec3, 2> before{scene.center(1), scene.center(2)};
            scene.step();
            for (const int i : {0, 1}) {
                const glm::dvec3 a = before[size_t(i)], b = scene.center(i + 1);
                if (!(a.y > 0.0 && b.y <= 0.0)) continue;
                const glm::dvec3 at = a + (b - a) * (a.y / (a.y - b.y));
                through = through || std::max(std::abs(at.x), std::abs(at.z)) < 2.8;  // not around its edge
            }
        }
        shots.through += through;
    }
    return shots;
}

SeamRide rideOverSeams(const PhysicsSettings& settings, int voxels, int shapes) {
    PhysicsScene scene(sleepless(settings));
    const uint8_t entry = setMaterial(scene, 7, 0.0f, 0.0f);
    const int each = (voxels + 40) / shapes;
    for (int i = 0; i < shapes; ++i) scene.add(solidGrid({each, 4, 30}, entry), {i * each * 0.1, -0.4, 0}, true);
    scene.add(solidGrid({7, 3, 7}, entry), {0.5, 0, 1.13}, false).velocity = {5, 0, 0};
    scene.load();
    SeamRide ride;
    const int steps = int(voxels * 0.1 / 5.0 * 60.0);
    const glm::dvec3 start = scene.center(shapes);
    for (int i = 0; i < steps; ++i) {
        scene.step();
        const glm::dvec3 c = scene.center(shapes);
        ride.highest = std::max(ride.highest, c.y - start.y);
        ride.aside = std::max(ride.aside, std::abs(c.z - start.z));
        ride.lost = std::max(ride.lost, 1.0 - double(scene.body(shapes).velocity.x) / 5.0);
    }
    return ride;
}

Collision collide(const PhysicsSettings& settings, double restitution) {
    PhysicsScene scene(sleepless(settings));
    scene.level.environment.gravity = {0, 0, 0};
    const uint8_t light = setMaterial(scene, 7, 0.5f, float(restitution), 1000),
                  heavy = setMaterial(scene, 8, 0.5f, float(restitution), 2000);
    scene.add(solidGrid({5, 5, 5}, light), {-1.013, 0, 0}, false).velocity = {3, 0, 0};
    scene.add(solidGrid({5, 5, 5}, heavy), {1.0, 0, 0}, false).velocity = {-1, 0, 0};
    scene.load();
    const double m1 = bodyMass(scene.world, scene.handle(0)).mass, m2 = bodyMass(scene.world, scene.handle(1)).mass;
    scene.seconds(1.0);
    const double v1 = scene.body(0).velocity.x, v2 = scene.body(1).velocity.x, before = m1 * 3 - m2;
    return {(m1 * v1 + m2 * v2 - before) / (m1 * 3 + m2), (v2 - v1) / 4.0};
}

Container fillContainer(const PhysicsSettings& settings, int count, double seconds) {
    PhysicsScene scene(sleepless(settings));
    const int inside = 6 * count + 2;  // cells
    scene.add(solidGrid({inside + 4, 2, inside + 4}, 7), {-0.2, -0.2, -0.2}, true);
    for (const int side : {0, 1}) {
        const double at = side ? inside * 0.1 : -0.2;
        scene.add(solidGrid({2, 12 * count, inside + 4}, 7), {at, 0, -0.2}, true);
        scene.add(solidGrid({inside + 4, 12 * count, 2}, 7), {-0.2, 0, at}, true);
    }
    for (int i = 0; i < count * count * count; ++i) {
        const glm::dvec3 cell(i % count, i / (count * count), i / count % count);
        scene.add(solidGrid({5, 5, 5}, 7), cell * 0.6 + glm::dvec3(0.1 + 0.02 * (i % 3), 0.05, 0.1 + 0.02 * (i % 5)),
                  false, glm::angleAxis(0.01 * (i % 7), glm::dvec3(0, 1, 0)));
    }
    scene.load();
    scene.seconds(seconds);
    Container result;
    std::vector<Pose> poses;
    for (int i = 0; i < int(scene.level.bodies.size()); ++i) {
        const Body& body = scene.body(i);
        poses.push_back(body.pose);
        if (body.isStatic) continue;
        result.fastest = std::max(result.fastest, double(glm::length(body.velocity)));
        const glm::dvec3 c = scene.center(i);
        result.allInside =
            result.allInside && c.y > 0 && c.x > 0 && c.z > 0 && c.x < inside * 0.1 && c.z < inside * 0.1;
    }
    const Overlaps overlaps = measureOverlaps(scene.level, poses);
    result.meanOverlap = overlaps.mean;
    result.worstOverlap = overlaps.worst;
    return result;
}

Recovery partOverlapping(const PhysicsSettings& settings, double share) {
    PhysicsScene scene(sleepless(settings));
    scene.addFloor();
    scene.add(solidGrid({5, 5, 5}, 7), {0, 0, 0}, false);
    scene.add(solidGrid({5, 5, 5}, 7), {0.02, 0.5 * (1.0 - share), 0.03}, false);
    scene.load();
    Recovery recovery;
    for (int i = 0; i < 180; ++i) {
        scene.step();
        for (const int k : {1, 2})
            recovery.fastest = std::max(recovery.fastest, double(glm::length(scene.body(k).velocity)));
    }
    recovery.overlap =
        measureOverlaps(scene.level, std::vector<Pose>{scene.body(0).pose, scene.body(1).pose, scene.body(2).pose})
            .worst;
    return recovery;
}

Level tumblingLevel(glm::dvec3 middle) {
    PhysicsScene scene;
    scene.addFloor(7, middle);
    for (int i = 0; i < 4; ++i) scene.add(solidGrid({5, 5, 5}, 7), middle + glm::dvec3(0.05 * i, 0.5 * i, 0), false);
    scene.add(solidGrid({9, 2, 3}, 7), middle + glm::dvec3(-3, 1.5, 1), false, glm::angleAxis(0.5, glm::dvec3(0, 0, 1)))
        .angularVelocity = {1, 2, 5};
    scene.add(tHandle(), middle + glm::dvec3(2, 2, -2), false).velocity = {-1, 0, 2};
    return scene.level;
}

std::vector<glm::dvec3> tumble(const PhysicsSettings& settings, glm::dvec3 middle) {
    PhysicsScene scene(settings);
    scene.level = tumblingLevel(middle);
    scene.load();
    scene.seconds(4.0);
    std::vector<glm::dvec3> at;
    for (int i = 1; i <= 6; ++i) at.push_back(scene.center(i) - middle);
    return at;
}

}  // namespace rubble::known
