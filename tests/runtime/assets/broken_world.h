#pragma once
#include <vector>

#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble::test {

/// A damaged wall, moving pieces of it, a light and a rope.
inline World brokenWorld(uint8_t id = 1) {
    Level level = oneShapeLevel(towerGrid({40, 40, 20}), true);
    level.lightGroups.push_back({"lantern"});
    level.lights.push_back({Light{.name = "bulb"}, "shape", "lantern"});
    LevelJoint rope{{.name = "rope", .kind = JointKind::Rope}, {"shape", ""}};
    rope.joint.ends[0].frame.position = {0.05, 0.05, 0.05};
    rope.joint.ends[1].frame.position = {5.0, 2.0, 0.0};
    level.joints.push_back(rope);
    World world(id);
    world.load(level);
    WorldSettings settings;
    settings.debris.bodies = 77;
    world.applyEdits({SettingsEdit{settings}, sphereCarve({1.0, 1.0, 1.0}, 0.6)});
    world.applyEdits({sphereCarve({2.0, 2.0, 0.2}, 0.7), PaintEdit{.position = {2.0, 3.0, 0.2}, .radius = 1.0}});
    world.applyEdits({PaintEdit{.position = {2.0, 1.0, 0.2}, .radius = 1.0, .mode = PaintMode::Layer}});
    std::vector<BodyPose> poses;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (!body.isStatic)
            poses.push_back({handle, {{1.0, 2.0, 3.0}}, {0.5, 0.0, 0.0}, {0.0, 0.1, 0.0}, poses.size() % 2 == 0});
    });
    world.setPoses(poses);
    return world;
}

}  // namespace rubble::test
