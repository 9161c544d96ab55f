#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "runtime/world/edits/edit.h"
#include "runtime/world/world.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble::test {

inline constexpr HistoryEdit kMark{HistoryAction::Mark}, kUndo{HistoryAction::Undo}, kRedo{HistoryAction::Redo};

/// A wall, a post that glows at its top, and a flying crate.
inline World smallWorld() {
    Level level = oneShapeLevel(solidGrid({40, 24, 6}, 1), true);
    level.lightGroups.push_back({"light", 0.3f});
    LevelBody post{.name = "post", .pose = {{6.0, 0.0, 0.0}}};
    LevelShape shape = levelShape("post", solidGrid({3, 30, 3}, 2));
    auto palette = std::make_shared<Palette>(*shape.palette);
    (*palette)[9] = (*palette)[1];
    (*palette)[9].emission = 5.0f;
    (*palette)[9].lightGroup = 1;
    shape.palette = palette;
    {
        GridWriter writer(shape.grid);
        for (int y = 26; y < 30; ++y) writer.set({1, y, 1}, 9), writer.set({0, y, 0}, 9);
    }
    post.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(post));
    LevelBody crate{.name = "crate", .pose = {{0.0, 4.0, 0.0}}, .isStatic = false, .velocity = {1.0f, 0.0f, 0.0f}};
    crate.shapes.push_back(levelShape("crate", solidGrid({12, 12, 12}, 1)));
    level.bodies.push_back(std::move(crate));
    level.lights.push_back({Light{.name = "bulb", .local = {{0.15, 2.8, 0.15}}}, "post", "light"});
    World world;
    world.load(level);
    WorldSettings settings;
    settings.undoMarks = 100;
    world.setSettings(settings);
    return world;
}

/// Moves every free body a little, in place of physics.
inline void move(World& world, double metres) {
    std::vector<BodyPose> poses;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.isStatic) return;
        BodyPose pose{handle, body.pose, body.velocity, body.angularVelocity, false};
        pose.pose.position.x += metres;
        pose.velocity.y -= metres;
        poses.push_back(pose);
    });
    world.setPoses(poses);
}

}  // namespace rubble::test
