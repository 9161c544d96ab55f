#pragma once
#include <memory>

#include "runtime/world/level/level.h"

namespace rubble {

/// Sets fields of a level's environment.
inline void setSampleEnvironment(Level& level) {
    level.environment.sunDirection = {0.1f, 0.7f, -0.3f};
    level.environment.exposure = 1.25f;
    level.environment.fogDensity = 0.02f;
    level.environment.fogBase = -1.0f;
    level.environment.fogHeight = 7.0f;
    level.environment.fogForward = 0.2f;
    level.environment.fogTint = {0.9f, 0.8f, 0.7f};
    level.environment.clouds = 0.25f;
    level.environment.stars = 0.5f;
    level.environment.gravity = {0.0f, -1.62f, 0.0f};
}

/// A palette of two entries.
inline std::shared_ptr<Palette> samplePalette() {
    auto palette = std::make_shared<Palette>();
    (*palette)[1] = {.red = 200,
                     .green = 10,
                     .blue = 30,
                     .opacity = 99,
                     .roughness = 3,
                     .metallic = 250,
                     .reflectivity = 77,
                     .material = 4};
    (*palette)[255] = {.red = 1, .green = 2, .blue = 3, .material = 18};
    return palette;
}

/// The same with a glowing entry.
inline std::shared_ptr<Palette> sampleGlowingPalette() {
    auto glowing = std::make_shared<Palette>(*samplePalette());
    (*glowing)[7] = {.red = 255, .green = 240, .blue = 200, .material = 1, .emission = 6.1f, .lightGroup = 2};
    return glowing;
}

/// A painted shape with bricks of all kinds.
inline LevelShape sampleWalls(const PaletteRef& palette) {
    LevelShape walls;
    walls.name = "walls.north";
    walls.grid = VoxelGrid({20, 9, 33});
    {
        GridWriter writer(walls.grid);
        for (int z = 0; z < 33; ++z)
            for (int y = 0; y < 9; ++y)
                for (int x = 0; x < 20; ++x)
                    if (x < 8 || (x + y * z) % 3 == 0)
                        writer.set({x, y, z}, x < 8 ? uint8_t(1) : uint8_t(x * 13 + y * 5 + z));
    }
    walls.paintColors =
        std::make_shared<const PaintColors>(PaintColors{.colors = {{{250, 0, 10}, {3, 2, 1}}}, .count = 2});
    VoxelGrid(walls.grid).forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
        if (brick.y > 0) return;
        BrickIndices indices, layer{};
        expandBrick(content.get(), indices);
        for (size_t i = 0; i < layer.size(); ++i)
            layer[i] = i % 3 ? paintByte(1 + int(i % 2), int(i % 17)) : uint8_t(0);
        walls.grid.setBrick(brick, makeBrick(indices, &layer));
    });
    walls.palette = palette;
    walls.anchors = {{{0, 0, 0}, {20, 1, 33}}, {{4, 0, 4}, {5, 9, 6}}};
    return walls;
}

/// A small rotated shape with a glowing voxel.
inline LevelShape sampleLantern() {
    LevelShape lantern;
    lantern.name = "lantern";
    lantern.local = {{0.3, 4.0, -2.5}, glm::angleAxis(1.1, glm::normalize(glm::dvec3(1, 2, 3)))};
    lantern.voxelSize = 0.05f;
    lantern.grid = VoxelGrid({3, 5, 2});
    {
        GridWriter writer(lantern.grid);
        writer.set({0, 4, 0}, 7);
        writer.set({2, 0, 1}, 1);
    }
    lantern.palette = sampleGlowingPalette();
    lantern.anchors = kNoAnchors;
    lantern.tags = {"light"};
    lantern.strength = 0.75f;
    lantern.loadBearing = false;
    lantern.collisionLayer = 4;
    lantern.collisionMask = 12;
    lantern.collisionShape = CollisionShape::CylinderY;
    return lantern;
}

/// Adds a moving body with a hidden shape without voxels.
inline void addSampleCart(Level& level, const PaletteRef& palette) {
    LevelBody cart;
    cart.name = "cart";
    cart.pose = {{-1000.25, 0.1, 3.75}, glm::angleAxis(-2.0, glm::normalize(glm::dvec3(0.2, 1, 0)))};
    cart.isStatic = false;
    cart.velocity = {1.5f, 0.0f, -0.25f};
    cart.angularVelocity = {0.0f, 0.1f, 0.0f};
    cart.gravityScale = 0.5;
    cart.linearDamping = 0.25, cart.angularDamping = 0.125;
    LevelShape empty;
    empty.name = "lantern";  // names need not be unique in a level
    empty.grid = VoxelGrid({40, 1, 1});
    empty.palette = palette;
    empty.hidden = true;
    cart.shapes.push_back(empty);
    level.bodies.push_back(cart);
}

/// Adds light groups, a cone light and a screen.
inline void addSampleLights(Level& level) {
    level.lightGroups = {{.name = "unused"},
                         {.name = "bulb", .threshold = 0.6f, .initialVoxels = 1, .removedVoxels = 0, .out = true}};
    LevelLight light;
    light.light.name = "bulb light";
    light.light.kind = LightKind::Cone;
    light.light.local.position = {0.01, 0.02, 0.03};
    light.light.color = {3.0f, 2.5f, 1.0f / 3.0f};
    light.light.reach = 9.0f;
    light.light.enabled = false;
    light.shapeName = "lantern";
    light.groupName = "bulb";
    level.lights.push_back(light);
    light.light.name = "news";
    light.light.kind = LightKind::Screen;
    light.light.width = 1.6f;
    light.light.height = 0.9f;
    light.light.twoSided = true;
    light.light.image = {2, {0xff0000, 0x123456, 0, 0xffffff}};
    level.lights.push_back(light);
}

/// Adds water, a trigger and a character.
inline void addSampleRegions(Level& level) {
    level.waters.push_back({.name = "pond",
                            .outline = {{0.0, 0.1}, {5.0, 0.0}, {2.0, 7.5}},
                            .surface = -0.3,
                            .depth = 2.5,
                            .density = 1025.0,
                            .linearDrag = 0.7,
                            .angularDrag = 0.6,
                            .flow = {0.1, 0.0, 0.2},
                            .color = {0.2f, 0.3f, 0.1f},
                            .clarity = 1.5f,
                            .waves = {0.1f, 3.0f, 1.0f, 0.5f}});
    level.triggers.push_back({.name = "doorway",
                              .kind = TriggerKind::Polygon,
                              .pose = {{1.0, 2.0, 3.0}, glm::angleAxis(0.4, glm::dvec3(0, 1, 0))},
                              .radius = 0.5,
                              .halfSize = {1.0, 2.0, 0.5},
                              .outline = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}},
                              .height = 2.0,
                              .layerMask = 6,
                              .tags = {"exit"}});
    Character player;
    player.name = "player";
    player.radius = 0.25;
    player.maxSlope = 0.8;
    player.collisionMask = 7;
    player.wish = {1.0, 0.0, 0.5};
    player.wantsCrouch = true;
    player.position = {3.0, 0.5, 4.0};
    player.velocity = {0.0, -1.0, 0.0};
    player.grounded = true;
    level.characters.push_back(player);
}

/// Adds a rope.
inline void addSampleJoint(Level& level) {
    LevelJoint rope{{.name = "line", .kind = JointKind::Rope}, {"walls.north", ""}};
    rope.joint.ends[0].frame = {{0.1, 0.2, 0.3}, glm::angleAxis(0.4, glm::dvec3(0, 0, 1))};
    rope.joint.ends[1] = {.frame = {{3.0, 4.0, 5.0}}, .cell = {1, 2, 3}, .radius = 0.7, .isFree = true};
    rope.joint.limits = {true, -0.5, 0.75};
    rope.joint.motor = {MotorMode::Position, 1.5, 200.0};
    rope.joint.spring = {3.0, 0.5};
    rope.joint.collides = true;
    rope.joint.friction = 7.0;
    rope.joint.breakForce = 1e4;
    rope.joint.breakTorque = 2e3;
    rope.joint.steer = 0.2;
    rope.joint.rope = {.length = 4.0,
                       .slack = 0.5,
                       .points = 2,
                       .radius = 0.05,
                       .massPerMetre = 3.0,
                       .stretch = 0.01,
                       .strength = 9e3,
                       .color = {1, 2, 3}};
    rope.joint.points = {{{1.0, 2.0, 3.0}, {0.1, 0.2, 0.3}}, {{4.0, 5.0, 6.0}}};
    level.joints.push_back(rope);
}

/// A level in which every field has a value that is not its default: rotated and moving bodies, shared and own
/// palettes, lights with groups, unusual names, an empty grid, uniform, full and mixed bricks.
inline Level sampleLevel() {
    Level level;
    level.name = "sample \"level\" \xc3\xa9";
    level.materials.materials.push_back(
        {.name = "cheese", .hardness = Hardness::Hard, .density = 950, .friction = 0.123f, .gun = false});
    setSampleEnvironment(level);
    level.scripts.push_back({"scripts/lift.lua", "speed=2\nname=\"lift\""});
    level.locations.emplace_back("spawn",
                                 Pose{{1.0 / 3.0, 2e-7, -12345.678}, glm::angleAxis(0.3, glm::dvec3(0, 1, 0))});
    const PaletteRef palette = samplePalette();
    LevelBody house;
    house.name = "house";
    house.tags = {"a=b", ""};
    house.shapes = {sampleWalls(palette), sampleLantern()};
    level.bodies.push_back(house);
    addSampleCart(level, palette);
    addSampleLights(level);
    addSampleRegions(level);
    addSampleJoint(level);
    level.tags = {{TaggedKind::Light, 1, {"news", "channel=2"}}, {TaggedKind::Joint, 0, {"layer=ropes"}}};
    return level;
}

}  // namespace rubble
