#include "tests/physics/scenes/seam_scenes.h"

#include <algorithm>
#include <cmath>

#include "physics/shapes/round_surface.h"
#include "runtime/core/constants.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble::known {

namespace {

LevelShape tileShape(const PhysicsScene& scene, const std::string& name, uint8_t entry, const Pose& pose) {
    LevelShape shape;
    shape.name = name;
    shape.grid = solidGrid({kTile, 4, kTile}, entry);
    shape.palette = scene.palette;
    shape.local = pose;
    return shape;
}

}  // namespace

void addTiledFloor(PhysicsScene& scene, Tiles tiles, uint8_t entry, const glm::dquat& turn) {
    const double size = 0.1 * kTile;
    if (tiles == Tiles::Slab) {
        scene.add(solidGrid({kTile * kTiles, 4, kTile * kTiles}, entry), turn * glm::dvec3(0, -0.4, 0), true, turn);
        return;
    }
    const bool isOneBody = tiles == Tiles::Shapes || tiles == Tiles::DynamicShapes;
    LevelBody body;
    body.name = "tiles";
    body.isStatic = tiles == Tiles::Shapes;
    body.pose = {glm::dvec3(0.0), turn};
    for (int x = 0; x < kTiles; ++x)
        for (int z = 0; z < kTiles; ++z) {
            Pose pose{{x * size, -0.4, z * size}, {1, 0, 0, 0}};
            if (tiles == Tiles::TurnedBodies) {
                const glm::dquat quarter = glm::angleAxis(0.5 * kPi * ((x + 2 * z) % 4), glm::dvec3(0, 1, 0));
                const glm::dvec3 half(0.5 * size, 0.0, 0.5 * size);
                pose = {pose.position + half - quarter * half, quarter};
            }
            const std::string name = "tile " + std::to_string(x) + " " + std::to_string(z);
            if (isOneBody)
                body.shapes.push_back(tileShape(scene, name, entry, pose));
            else
                scene.add(solidGrid({kTile, 4, kTile}, entry), turn * pose.position, true, turn * pose.rotation);
        }
    if (isOneBody) scene.level.bodies.push_back(body);
}

Ride rideOver(Tiles tiles, const Rider& rider, const glm::dquat& turn) {
    PhysicsScene scene(sleepless({}));
    const uint8_t entry = setMaterial(scene, 7, float(rider.friction), 0.0f),
                  heavy = setMaterial(scene, 8, float(rider.friction), 0.0f, 20000);
    const glm::dvec3 up = turn * glm::dvec3(0, 1, 0), along = turn * glm::dvec3(std::cos(0.2), 0, std::sin(0.2)),
                     across = glm::cross(along, up);
    scene.level.environment.gravity = glm::vec3(up * -9.81);
    addTiledFloor(scene, tiles, tiles == Tiles::DynamicShapes ? heavy : entry, turn);
    if (tiles == Tiles::DynamicShapes)
        scene.add(solidGrid({200, 10, 200}, entry), turn * glm::dvec3(-3, -1.4, -3), true, turn);
    const bool rolls = rider.shape != CollisionShape::Voxels;
    const glm::dvec3 half = glm::dvec3(rider.grid.size()) * 0.05;
    const CellBox cells{glm::ivec3(0), rider.grid.size()};
    const double height = rolls ? 0.1 * double(fitRoundSurface(rider.grid, cells, rider.shape)->radius) : half.y;
    const glm::dquat rotation = turn * glm::angleAxis(rider.yaw - 0.2, glm::dvec3(0, 1, 0));
    LevelBody& body = scene.add(rider.grid, turn * glm::dvec3(0.9, height, 4.1) - rotation * half, false, rotation);
    body.shapes[0].collisionShape = rider.shape;
    body.velocity = glm::vec3(along * rider.speed);
    if (rolls) body.angularVelocity = glm::vec3(across * (-rider.speed / height));
    scene.load();
    const int number = int(scene.level.bodies.size()) - 1;
    const glm::dvec3 start = scene.center(number), side = rotation * glm::dvec3(0, 0, 1);
    Ride ride;
    for (int i = 0; i < scene.stepsIn(10.0 / rider.speed); ++i) {
        scene.step();
        ride.highest = std::max(ride.highest, glm::dot(scene.center(number) - start, up));
    }
    const glm::dvec3 way = scene.center(number) - start;
    ride.distance = glm::dot(way, along), ride.aside = glm::dot(way, across);
    ride.turned = std::asin(glm::dot(glm::cross(side, scene.body(number).pose.rotation * glm::dvec3(0, 0, 1)), up));
    return ride;
}

namespace {

/// Two slabs of 3 m whose tops are at y = 0, before x = 0 and behind the gap.
void addSlabs(PhysicsScene& scene, const GapSlide& slide, uint8_t entry) {
    const int length = int(std::lround(3.0 / slide.voxel)), height = 3;
    const bool isOneBody = slide.tiles == Tiles::Shapes, moves = slide.tiles == Tiles::DynamicShapes;
    const double top = height * slide.voxel;
    for (const double from : {-length * slide.voxel, slide.gap}) {
        const glm::dvec3 corner(from, -top, -0.5 * length * slide.voxel);
        if (!isOneBody || scene.level.bodies.empty()) {
            scene.add(solidGrid({length, height, length}, entry), corner, !moves).shapes[0].voxelSize =
                float(slide.voxel);
            continue;
        }
        LevelShape shape = scene.level.bodies[0].shapes[0];
        shape.name = "second";
        shape.local.position = corner - scene.level.bodies[0].pose.position;
        scene.level.bodies[0].shapes.push_back(shape);
    }
    if (moves) scene.add(solidGrid({200, 10, 200}, 7), {-10, -1.0 - top, -10}, true);
}

}  // namespace

GapRide rideOverGap(const GapSlide& slide) {
    PhysicsScene scene(sleepless({}));
    const uint8_t slippery = setMaterial(scene, 6, 0.0f, 0.0f);
    setMaterial(scene, 7, 1.0f, 0.0f);
    addSlabs(scene, slide, slippery);
    const int crate = int(scene.level.bodies.size()), approach = 4;
    const glm::dquat rotation = glm::angleAxis(slide.yaw, glm::dvec3(0, 1, 0));
    const double front = 0.2 * (std::abs(std::cos(slide.yaw)) + std::abs(std::sin(slide.yaw))),
                 step = slide.speed * scene.stepSeconds, start = slide.gap + slide.beyond - front - approach * step;
    scene.add(solidGrid({4, 2, 4}, slippery), glm::dvec3(start, 0.1, 0.0) - rotation * glm::dvec3(0.2, 0.1, 0.2), false,
              rotation);
    scene.load();
    scene.seconds(0.5);
    const double height = scene.center(crate).y;
    scene.stepWith({SetBodyEdit{.body = scene.handle(crate), .setsVelocity = true, .velocity = {slide.speed, 0, 0}}});
    GapRide ride;
    for (int i = 1; i < approach + int((slide.gap + 1.0) / step); ++i) {
        scene.step();
        const glm::dvec3 up = scene.body(crate).pose.rotation * glm::dvec3(0, 1, 0);
        ride.highest = std::max(ride.highest, scene.center(crate).y - height);
        ride.tilted = std::max(ride.tilted, std::acos(std::min(up.y, 1.0)));
    }
    ride.lost = 1.0 - double(scene.body(crate).velocity.x) / slide.speed;
    return ride;
}

}  // namespace rubble::known
