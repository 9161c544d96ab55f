#pragma once
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "physics/physics_world.h"
#include "runtime/world/world.h"
#include "tests/support/grids.h"

namespace rubble {

constexpr double kGravity = 9.81;  ///< m/s2, of worlds by default

/// A palette whose entry i is of material i of the default table.
inline PaletteRef materialPalette() {
    auto palette = std::make_shared<Palette>();
    for (size_t i = 1; i < defaultMaterials().materials.size(); ++i) (*palette)[i].material = uint8_t(i);
    return palette;
}

/// A level made of grids, a World and its physics, stepped as the frame loop does.
struct PhysicsScene {
    /// An empty level.
    explicit PhysicsScene(const PhysicsSettings& settings = {})
        : stepSeconds(settings.stepSeconds), physics(settings) {}

    /// Adds a body of one shape to the level. corner: of its grid, world, metres.
    LevelBody& add(VoxelGrid grid, glm::dvec3 corner, bool isStatic, glm::dquat rotation = {1, 0, 0, 0}) {
        LevelBody body;
        body.name = "body " + std::to_string(level.bodies.size());
        body.isStatic = isStatic;
        body.pose = {corner, rotation};
        LevelShape shape;
        shape.name = body.name;
        shape.grid = std::move(grid);
        shape.palette = palette;
        body.shapes.push_back(std::move(shape));
        level.bodies.push_back(std::move(body));
        return level.bodies.back();
    }
    /// A floor of 20 x 20 m whose top is at y = 0 around `middle`.
    void addFloor(uint8_t entry = 7, glm::dvec3 middle = {0, 0, 0}) {
        add(solidGrid({200, 10, 200}, entry), middle + glm::dvec3(-10, -1, -10), true);
    }

    /// Loads the level into World and physics. wakeAll: dynamic bodies of a level start asleep; wake them.
    void load(bool wakeAll = true) {
        world.load(level);
        physics.load(world);
        if (!wakeAll) return;
        FrameChanges nudge;
        world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (!body.isStatic) nudge.impulses.push_back({handle, body.pose.position, glm::dvec3(0.0)});
        });
        physics.apply(nudge, world);
    }
    /// Loads the level as it is now into a new World with the same handles: what edits would have made of it.
    void replaceWorld() {
        world = World();
        world.load(level);
    }
    /// Steps without edits.
    void step(int count = 1) {
        for (int i = 0; i < count; ++i) {
            physics.step();
            copyMotion(physics, world);
        }
    }
    /// One step with edits. Returns what they changed.
    FrameChanges stepWith(const Edits& edits) {
        FrameChanges changes = world.applyEdits(edits);
        physics.apply(changes, world);
        step();
        return changes;
    }
    /// The number of steps in a time, rounded.
    int stepsIn(double seconds) const { return int(std::lround(seconds / stepSeconds)); }
    /// Steps through a time.
    void seconds(double time) { step(stepsIn(time)); }

    /// The handle of the body with this index in the World's order.
    BodyHandle handle(int index) const {
        BodyHandle found;
        int i = 0;
        world.bodies().forEach([&](BodyHandle h, const Body&) {
            if (i++ == index) found = h;
        });
        return found;
    }
    /// By index, as handle().
    const Body& body(int index) const { return world.bodies().at(handle(index)); }
    /// The centre of mass of a body, world, metres.
    glm::dvec3 center(int index) const {
        return body(index).pose.transformPoint(bodyMass(world, handle(index)).center);
    }

    PaletteRef palette = materialPalette();
    Level level;
    World world;
    double stepSeconds;
    PhysicsWorld physics;
};

}  // namespace rubble
