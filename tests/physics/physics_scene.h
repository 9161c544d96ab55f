#pragma once
#include <cmath>
#include <string>

#include "physics/physics_world.h"
#include "runtime/world/world.h"

namespace rubble {

/// A palette whose entry i is of material i of the default table.
inline PaletteRef materialPalette() {
    auto palette = std::make_shared<Palette>();
    for (size_t i = 1; i < defaultMaterials().materials.size(); ++i) (*palette)[i].material = uint8_t(i);
    return palette;
}

inline VoxelGrid blockGrid(glm::ivec3 size, uint8_t entry) {
    VoxelGrid grid(size);
    GridWriter writer(grid);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) writer.set({x, y, z}, entry);
    return grid;
}

/// A level made of grids, a World and its physics, stepped together as the frame loop does.
struct PhysicsScene {
    explicit PhysicsScene(const PhysicsSettings& settings = {})
        : stepSeconds(settings.stepSeconds), physics(settings) {}

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
        add(blockGrid({200, 10, 200}, entry), middle + glm::dvec3(-10, -1, -10), true);
    }

    void load(bool wakeAll = true) {
        world.load(level);
        FrameChanges changes;
        changes.levelReplaced = true;
        physics.apply(changes, world);
        if (!wakeAll) return;
        FrameChanges nudge;  // dynamic bodies of a level start asleep
        world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (!body.isStatic) nudge.impulses.push_back({handle, body.pose.position, glm::dvec3(0.0)});
        });
        physics.apply(nudge, world);
    }
    /// The level as it is now in a new World of the same handles: what edits would have made of it.
    void replaceWorld() {
        world = World();
        world.load(level);
    }
    void step(int count = 1) {
        for (int i = 0; i < count; ++i) {
            physics.step();
            world.setPoses(physics.poses());
            world.setRopes(physics.ropes());
        }
    }
    int stepsIn(double seconds) const { return int(std::lround(seconds / stepSeconds)); }
    void seconds(double time) { step(stepsIn(time)); }

    BodyHandle handle(int index) const {
        BodyHandle found;
        int i = 0;
        world.bodies().forEach([&](BodyHandle h, const Body&) {
            if (i++ == index) found = h;
        });
        return found;
    }
    const Body& body(int index) const { return world.bodies().at(handle(index)); }
    glm::dvec3 center(int index) const { return body(index).pose.transformPoint(world.bodyMass(handle(index)).center); }

    PaletteRef palette = materialPalette();
    Level level;
    World world;
    double stepSeconds;
    PhysicsWorld physics;
};

}  // namespace rubble
