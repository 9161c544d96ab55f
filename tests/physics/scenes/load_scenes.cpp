#include "tests/physics/scenes/load_scenes.h"

#include <algorithm>
#include <cmath>

#include "physics/water/submersion.h"
#include "tests/physics/scenes/energy.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble::known {

Pool::Pool(const PhysicsSettings& settings, uint32_t density, double drag, double halfSide, double depth)
    : PhysicsScene(sleepless(settings)) {
    level.materials.materials[1].density = density;
    level.materials.materials[1].restitution = 0.0f;
    const double s = halfSide;
    level.waters.push_back({.name = "pool",
                            .outline = {{-s, -s}, {s, -s}, {s, s}, {-s, s}},
                            .depth = depth,
                            .linearDrag = drag,
                            .angularDrag = drag});
}

double Pool::submerged(int index) const {
    const Body& body = world.bodies().at(handle(index));
    const Shape& shape = world.shapes().at(body.shapes[0]);
    const ColliderPart part(shape, Pose{}, world.materials());
    const double size = double(shape.voxelSize);
    const CellTransform cells{glm::mat3_cast(body.pose.rotation) * size, {}};
    Submersion sum;
    addSubmersion(part, cells, body.pose.position, world.waters().at(world.waters().handleAt(0)), sum);
    return sum.volume / (double(shape.grid.size().x * shape.grid.size().y * shape.grid.size().z) * size * size * size);
}

double floatInShallowWater(const PhysicsSettings& settings, glm::ivec3 size, uint32_t density) {
    Pool scene(settings, density, 1.5, 50.0, 0.3);
    scene.addFloor(7, {0.0, -0.3, 0.0});
    scene.add(solidGrid(size, 1), {0.0, -0.05, 0.0}, false);
    scene.load();
    scene.seconds(20.0);
    return scene.submerged(1);
}

uint8_t entryOfMass(PhysicsScene& scene, double mass, int voxels, uint8_t entry) {
    return setMaterial(scene, entry, 0.5f, 0.0f, uint32_t(std::max(1L, std::lround(mass / (voxels * 1e-3)))));
}

LevelJoint& addJoint(PhysicsScene& scene, JointKind kind, std::string first, std::string second, glm::dvec3 in,
                     glm::dvec3 at) {
    LevelJoint joint{{.kind = kind}, {std::move(first), std::move(second)}};
    joint.joint.ends[0].frame.position = in;
    joint.joint.ends[1].frame.position = at;
    scene.level.joints.push_back(joint);
    return scene.level.joints.back();
}

void addWinding(PhysicsScene& scene, int diameter, double mass, double speed) {
    const double radius = 0.05 * diameter;
    const VoxelGrid pole = gridOf({diameter, 80, diameter}, [&](glm::ivec3 cell) {
        const double x = cell.x + 0.5 - 0.5 * diameter, z = cell.z + 0.5 - 0.5 * diameter;
        return uint8_t(x * x + z * z <= 0.25 * diameter * diameter ? 7 : 0);
    });
    scene.add(pole, {-radius, -4.0, -radius}, true);
    scene.add(solidGrid({4, 4, 4}, entryOfMass(scene, mass, 64)), {5.8, -0.2, radius}, false).velocity = {0.0f, 0.0f,
                                                                                                          float(speed)};
    addJoint(scene, JointKind::Rope, "body 0", "body 1", {radius, 4.0, 2.0 * radius}, {0.0, 0.2, 0.2})
        .joint.rope.points = 25;
}

Winding windRope(const PhysicsSettings& settings, double gravity, int diameter, double mass, double speed, int steps) {
    PhysicsScene scene(sleepless(settings));
    scene.level.environment.gravity = {0.0f, -float(gravity), 0.0f};
    addWinding(scene, diameter, mass, speed);
    scene.load();
    EnergyRecord energy(scene.world, settings);
    for (int i = 0; i < steps; ++i) {
        scene.step();
        energy.update(scene.world);
    }
    return {energy.excess(), energy.lost(), mechanicalEnergy(scene.world, 0.0)};
}

PlankWalk::PlankWalk(const PhysicsSettings& settings, double mass) : PhysicsScene(settings) {
    addFloor(7, {0.0, -1.5, 0.0});
    add(solidGrid({30, 15, 20}, 7), {-3.0, -1.5, -1.0}, true);
    // 50 x 1 x 5 voxels
    const uint8_t wood = setMaterial(*this, 8, 0.6f, 0.0f, uint32_t(std::lround(mass / 0.25)));
    add(solidGrid({50, 1, 5}, wood), {-3.5, 0.0, -0.25}, false);
    level.characters.emplace_back();
    level.characters[0].position = {-0.5, 0.12, 0.0};
}

double PlankWalk::walkTo(double x, double seconds) {
    const double before = tip();
    const double direction = x > me().position.x ? 1.0 : -1.0;
    stepWith({MoveCharacterEdit{who(), {direction, 0.0, 0.0}}});
    for (int i = 0; i < 600 && (x - me().position.x) * direction > 0.0; ++i) step();
    stepWith({MoveCharacterEdit{who(), {}}});
    this->seconds(seconds);
    return before - tip();
}

}  // namespace rubble::known
