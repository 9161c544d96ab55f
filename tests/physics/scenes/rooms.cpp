#include "tests/physics/scenes/rooms.h"

#include <algorithm>

#include "tests/physics/scenes/known_scenes.h"

namespace rubble::known {
namespace {

constexpr int kMaxBodies = 40, kSteps = 40;
constexpr double kMaxSpeed = 300.0;  ///< m/s

/// Random numbers of a room.
struct Dice {
    Random random;
    double uniform(double low, double high) {
        return low + (high - low) * (double(random.below(1u << 30)) / double(1u << 30));
    }
    int whole(int low, int high) { return low + int(random.below(uint32_t(high - low + 1))); }
    glm::dvec3 direction() {
        for (;;) {
            const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
            const double length = glm::length(glm::dvec3(x, y, z));
            if (length > 0.1 && length < 1.0) return glm::dvec3(x, y, z) / length;
        }
    }
    glm::dquat rotation() {
        const glm::dvec3 axis = direction();
        return glm::angleAxis(uniform(0.0, 6.28), axis);
    }
};

enum class RoomKind { Box, Shaft, Pipe, Stairs, Wedge };

struct Room {
    RoomKind kind;
    glm::ivec3 inside;  ///< cells
    int wall;           ///< cells
    /// Of the whole room.
    glm::ivec3 size() const { return inside + 2 * wall; }
    bool solid(glm::ivec3 cell) const {
        const glm::ivec3 c = cell - wall;
        if (glm::any(glm::lessThan(c, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(c, inside))) return true;
        if (kind == RoomKind::Pipe) {
            const glm::dvec3 from = glm::dvec3(c) + 0.5 - glm::dvec3(inside) * 0.5;
            return from.x * from.x + from.z * from.z > 0.25 * inside.x * inside.x;
        }
        if (kind == RoomKind::Stairs) return c.y < std::min(c.x / 3, inside.y / 2);
        if (kind == RoomKind::Wedge) return std::abs(2 * c.x + 1 - inside.x) > c.y + 3;
        return false;
    }
};

Room randomRoom(Dice& dice) {
    Room room{RoomKind(dice.whole(0, 4)), glm::ivec3(0), dice.whole(1, 4)};
    for (int axis = 0; axis < 3; ++axis) room.inside[axis] = dice.whole(14, 40);
    if (room.kind == RoomKind::Shaft || room.kind == RoomKind::Pipe) room.inside.x = room.inside.z = dice.whole(9, 12);
    return room;
}

/// The room as shapes that are cut at random planes: of one body if it is free, else of a body each.
void addRoom(PhysicsScene& scene, const Room& room, Dice& dice, const Pose& pose, bool isFree) {
    const bool isCut = dice.whole(0, 1) == 1;
    std::array<std::vector<int>, 3> cuts;
    for (int axis = 0; axis < 3; ++axis) {
        cuts[size_t(axis)] = {0, room.size()[axis]};
        if (isCut) cuts[size_t(axis)].insert(cuts[size_t(axis)].begin() + 1, dice.whole(1, room.size()[axis] - 1));
    }
    for (size_t x = 0; x + 1 < cuts[0].size(); ++x)
        for (size_t y = 0; y + 1 < cuts[1].size(); ++y)
            for (size_t z = 0; z + 1 < cuts[2].size(); ++z) {
                const glm::ivec3 low(cuts[0][x], cuts[1][y], cuts[2][z]),
                    high(cuts[0][x + 1], cuts[1][y + 1], cuts[2][z + 1]);
                VoxelGrid grid = gridOf(high - low, [&](glm::ivec3 c) { return uint8_t(room.solid(c + low) ? 7 : 0); });
                if (grid.empty()) continue;
                if (!isFree || scene.level.bodies.empty()) {
                    scene.add(std::move(grid), pose.transformPoint(glm::dvec3(low) * 0.1), !isFree, pose.rotation);
                    continue;
                }
                LevelShape shape{.name = "part " + std::to_string(scene.level.bodies[0].shapes.size())};
                shape.grid = std::move(grid);
                shape.palette = scene.palette;
                shape.local.position = glm::dvec3(low) * 0.1;
                scene.level.bodies[0].shapes.push_back(std::move(shape));
            }
}

VoxelGrid randomBody(Dice& dice) {
    glm::ivec3 size(dice.whole(1, 6), dice.whole(1, 6), dice.whole(1, 6));
    if (dice.whole(0, 3) == 0) size[dice.whole(0, 2)] = 1;
    const bool isCross = dice.whole(0, 4) == 0;
    return gridOf(size, [&](glm::ivec3 c) {
        int middles = 0;
        for (int axis = 0; axis < 3; ++axis) middles += c[axis] == size[axis] / 2;
        return uint8_t(isCross && middles < 2 ? 0 : 7);
    });
}

}  // namespace

RoomShots throwIntoRoom(const PhysicsSettings& settings, uint64_t seed, RoomBody body) {
    const bool isFree = body == RoomBody::Free;
    Dice dice{Random(seed)};
    const Room room = randomRoom(dice);
    const bool isTurned = dice.whole(0, 1) == 1;
    const Pose pose{glm::dvec3(0.0), isTurned ? dice.rotation() : glm::dquat(1, 0, 0, 0)};
    PhysicsScene scene(sleepless(settings));
    scene.level.bounds = {glm::dvec3(-1e4), glm::dvec3(1e4)};
    addRoom(scene, room, dice, pose, isFree);
    const int walls = int(scene.level.bodies.size());
    // A lattice of places with room for each body at any rotation, of which those inside walls are left out.
    std::vector<glm::dvec3> places;
    for (int z = 5; z + 5 <= room.inside.z; z += 9)
        for (int y = 5; y + 5 <= room.inside.y; y += 9)
            for (int x = 5; x + 5 <= room.inside.x; x += 9) {
                bool isOpen = true;
                for (int i = 0; i < 11 * 11 * 11; ++i) {
                    const glm::ivec3 c(x - 5 + i % 11, y - 5 + i / 11 % 11, z - 5 + i / 121);
                    const glm::dvec3 from = glm::dvec3(c) + 0.5 - glm::dvec3(x, y, z);
                    isOpen = isOpen && (glm::length(from) > 5.3 || !room.solid(c + room.wall));
                }
                if (isOpen) places.push_back(glm::dvec3(x, y, z) + double(room.wall));
            }
    RoomShots result;
    for (const glm::dvec3& place : places) {
        if (result.thrown == kMaxBodies) break;
        const glm::dquat turn = dice.rotation();
        VoxelGrid grid = randomBody(dice);
        if (grid.empty()) continue;
        const glm::dvec3 half = glm::dvec3(grid.size()) * 0.05;
        LevelBody& thrown = scene.add(std::move(grid), pose.transformPoint(place * 0.1) - turn * half, false, turn);
        const double power = dice.uniform(0.0, 1.0);
        const double speed = std::pow(kMaxSpeed, power);
        thrown.velocity = glm::vec3(dice.direction() * speed);
        thrown.angularVelocity = glm::vec3(dice.direction() * dice.uniform(0.0, 30.0));
        ++result.thrown;
    }
    if (isFree) {
        scene.level.environment.gravity = {0, 0, 0};
        scene.level.bodies[0].velocity = glm::vec3(dice.direction() * dice.uniform(0.0, 10.0));
        scene.level.bodies[0].angularVelocity = glm::vec3(dice.direction() * dice.uniform(0.0, 3.0));
    }
    scene.load();
    const int all = walls + result.thrown;
    std::vector<bool> isOutside(size_t(all), false);
    glm::dvec3 spin = dice.direction();
    for (int step = 0; step < kSteps; ++step) {
        Edits edits;
        if (step % 4 == 0 && !isFree) {
            Environment environment = scene.world.environment();
            environment.gravity = glm::vec3(glm::angleAxis(0.05 * step, spin) * glm::dvec3(0.0, -9.81, 0.0));
            edits.push_back(SetEnvironmentEdit{environment});
        }
        scene.stepWith(edits);
        const Pose now = isFree ? scene.body(0).pose : pose;
        for (int i = walls; i < all; ++i) {
            if (isOutside[size_t(i)]) continue;
            const glm::dvec3 at = now.inversePoint(scene.center(i)) * 10.0;
            if (glm::all(glm::greaterThan(at, glm::dvec3(0.0))) && glm::all(glm::lessThan(at, glm::dvec3(room.size()))))
                continue;
            isOutside[size_t(i)] = true;
            ++result.outside;
        }
    }
    return result;
}

}  // namespace rubble::known
