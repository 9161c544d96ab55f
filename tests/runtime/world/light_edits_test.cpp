#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

/// A post of entry 1 with a glowing head of entry 6 and a light inside the head; 10 cells are 1 m.
Level lightPost() {
    VoxelGrid grid({8, 40, 8});
    {
        GridWriter writer(grid);
        for (int y = 0; y < 40; ++y)
            for (int i = 0; i < 16; ++i) writer.set({2 + i % 4, y, 2 + i / 4}, y < 34 ? 1 : 6);
    }
    Level level = test::oneShapeLevel(std::move(grid), true);
    Palette palette = test::fiveEntries();
    palette[6] = {.material = 1, .emission = 4.0f, .lightGroup = 1};
    level.bodies[0].shapes[0].palette = std::make_shared<const Palette>(palette);
    level.lightGroups.push_back({.name = "light", .threshold = 0.4f});
    level.lights.push_back(
        {.light = {.name = "bulb", .local = {{0.4, 3.7, 0.4}}}, .shapeName = "shape", .groupName = "light"});
    return level;
}

const Light& firstLight(const World& world) {
    const Light* first = nullptr;
    world.lights().forEach([&](LightHandle, const Light& light) { first = &light; });
    return *first;
}

bool anyGlow(const World& world) {
    bool glows = false;
    world.shapes().forEach([&](ShapeHandle, const Shape& shape) {
        for (const PaletteEntry& entry : *shape.palette)
            glows = glows || (entry.lightGroup == 1 && entry.emission > 0.0f);
    });
    return glows;
}

TEST(LightEdits, ALightFollowsItsPiece) {
    World world;
    world.load(lightPost());
    const glm::dvec3 before = lightToWorld(world, firstLight(world)).position;
    const FrameChanges changes = world.applyEdits({test::sphereCarve({0.4, 1.5, 0.4}, 0.4)});
    ASSERT_EQ(changes.splits.size(), 1u);
    EXPECT_EQ(changes.lights.size(), 1u);
    EXPECT_EQ(firstLight(world).shape, changes.splits[0].children[0]);
    EXPECT_LT(glm::length(lightToWorld(world, firstLight(world)).position - before), 1e-6);
    EXPECT_TRUE(firstLight(world).enabled);
    EXPECT_TRUE(changes.groupsOut.empty());
}

TEST(LightEdits, AGroupGoesOutWhenEnoughOfItIsGone) {
    World world;
    world.load(lightPost());
    // Half of the head is above the threshold, a corner of it is below.
    const FrameChanges corner = world.applyEdits({test::sphereCarve({0.2, 4.0, 0.2}, 0.15)});
    EXPECT_TRUE(corner.groupsOut.empty());
    EXPECT_TRUE(anyGlow(world));
    CarveEdit half{.kind = BrushKind::Box, .position = {0.4, 3.85, 0.4}, .halfSize = {1.0, 0.16, 1.0}};
    const FrameChanges changes = world.applyEdits({half});
    ASSERT_EQ(changes.groupsOut.size(), 1u);
    EXPECT_TRUE(world.lightGroups().at(changes.groupsOut[0]).out);
    EXPECT_FALSE(firstLight(world).enabled);
    EXPECT_EQ(changes.lights.size(), 1u);
    EXPECT_FALSE(changes.palettes.empty());
    EXPECT_FALSE(anyGlow(world));
    EXPECT_TRUE(world.applyEdits({half}).groupsOut.empty()) << "it goes out once";
}

TEST(LightEdits, PiecesGoDarkWithTheirGroup) {
    World world;
    world.load(lightPost());
    // Two cuts make three shapes; then a third removes more of the head.
    world.applyEdits({test::sphereCarve({0.4, 1.5, 0.4}, 0.4)});
    world.applyEdits({CarveEdit{.kind = BrushKind::Box, .position = {0.4, 3.65, 0.4}, .halfSize = {1.0, 0.06, 1.0}}});
    EXPECT_EQ(world.shapes().size(), 3u);
    EXPECT_TRUE(anyGlow(world));
    const FrameChanges changes = world.applyEdits(
        {CarveEdit{.kind = BrushKind::Box, .position = {0.4, 3.95, 0.4}, .halfSize = {1.0, 0.11, 1.0}}});
    EXPECT_EQ(changes.groupsOut.size(), 1u);
    EXPECT_EQ(changes.palettes.size(), world.shapes().size());
    EXPECT_FALSE(anyGlow(world));
}

TEST(LightEdits, PaintSurvivesASplit) {
    World world;
    world.load(lightPost());
    for (int i = 0; i < 20; ++i)
        world.applyEdits({PaintEdit{.position = {0.2, 2.8, 0.4}, .radius = 0.25, .color = {1, 2, 250}}});
    const auto blueVoxels = [&] {
        int count = 0;
        world.shapes().forEach([&](ShapeHandle, const Shape& shape) {
            shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
                forEachVoxel(brick->occupancy, [&](int i) {
                    const PaletteEntry& entry = (*shape.palette)[brick->at(i)];
                    count += entry.red == 1 && entry.green == 2 && entry.blue == 250;
                });
            });
        });
        return count;
    };
    const int painted = blueVoxels();
    EXPECT_GT(painted, 5);
    const FrameChanges changes = world.applyEdits({test::sphereCarve({0.4, 1.5, 0.4}, 0.4)});
    ASSERT_EQ(changes.splits.size(), 1u);
    EXPECT_EQ(blueVoxels(), painted);
}

/// A wall with a light at the top, and a wire that leads up to it from a supply at the bottom.
Level wiredLight(uint32_t flickerSteps) {
    VoxelGrid grid = solidGrid({24, 40, 6});
    {
        GridWriter writer(grid);
        for (int y = 4; y <= 20; ++y) writer.set({4, y, 5}, 7);
        for (int x = 4; x <= 18; ++x) writer.set({x, 20, 5}, 7);
        for (int y = 20; y < 34; ++y) writer.set({18, y, 5}, 7);
        for (int y = 34; y < 38; ++y)
            for (int x = 16; x < 20; ++x) writer.set({x, y, 5}, 6);
    }
    Level level = test::oneShapeLevel(std::move(grid), true);
    level.materials.materials.push_back({.name = "wire", .hardness = Hardness::Soft});
    Palette palette = test::fiveEntries();
    palette[6] = {.material = 1, .emission = 4.0f, .lightGroup = 1};
    palette[7] = {.material = 6};
    level.bodies[0].shapes[0].palette = std::make_shared<const Palette>(palette);
    level.lightGroups.push_back(
        {.name = "light", .supplyShape = "shape", .supplyCell = {4, 4, 5}, .flickerSteps = flickerSteps});
    level.lights.push_back(
        {.light = {.name = "bulb", .local = {{1.8, 3.6, 0.6}}}, .shapeName = "shape", .groupName = "light"});
    return level;
}

TEST(LightEdits, CuttingTheWireTurnsTheLightOff) {
    World world;
    world.load(wiredLight(0));
    EXPECT_TRUE(world.applyEdits({test::sphereCarve({1.0, 1.0, 0.6}, 0.35)}).groupsOut.empty()) << "beside the wire";
    EXPECT_TRUE(anyGlow(world));
    EXPECT_TRUE(world.applyEdits({test::sphereCarve({0.4, 3.0, 0.6}, 0.35)}).groupsOut.empty())
        << "above where it turns";
    const FrameChanges cut = world.applyEdits({test::sphereCarve({1.2, 2.05, 0.6}, 0.2)});
    EXPECT_EQ(cut.groupsOut.size(), 1u);
    EXPECT_FALSE(anyGlow(world));
    EXPECT_FALSE(firstLight(world).enabled);
}

TEST(LightEdits, ALightCutOffItsWireGoesOut) {
    World world;
    world.load(wiredLight(0));
    // Cuts off the top of the wall with the light; wire is left on both sides of the cut.
    CarveEdit saw{.kind = BrushKind::Box, .position = {1.2, 3.0, 0.3}, .halfSize = {2.0, 0.05, 1.0}};
    const FrameChanges cut = world.applyEdits({saw});
    EXPECT_EQ(cut.splits.size(), 1u);
    EXPECT_EQ(cut.groupsOut.size(), 1u);
    EXPECT_FALSE(anyGlow(world));
}

TEST(LightEdits, OneThatFailsWhenItsLevelIsLoadedGoesOutByItself) {
    Level level = wiredLight(3);
    level.lightGroups[0].failingSince = 1;
    World world;
    world.load(level);
    size_t out = 0;
    for (int step = 0; step < 5; ++step) out += world.applyEdits({}).groupsOut.size();
    EXPECT_EQ(out, 1u);
    EXPECT_FALSE(anyGlow(world));
}

TEST(LightEdits, ItFlickersTheSameEveryTimeBeforeItIsOut) {
    std::vector<bool> first;
    for (int run = 0; run < 2; ++run) {
        World world;
        world.load(wiredLight(30));
        world.applyEdits({test::sphereCarve({1.2, 2.05, 0.6}, 0.2)});
        std::vector<bool> dark;
        int steps = 1;
        for (; anyGlow(world) && steps < 100; ++steps) {
            const FrameChanges changes = world.applyEdits({});
            world.lightGroups().forEach([&](LightGroupHandle, const LightGroup& group) { dark.push_back(group.dark); });
            const bool switched = dark.size() > 1 && dark.back() != dark[dark.size() - 2] && anyGlow(world);
            EXPECT_FALSE(switched && changes.lights.empty());
        }
        EXPECT_EQ(steps, 31);
        EXPECT_TRUE(world.applyEdits({}).empty()) << "nothing more happens";
        EXPECT_GE(std::count(dark.begin(), dark.end(), true), 3);
        if (run == 0) first = dark;
        EXPECT_EQ(dark, first);
    }
}

TEST(LightEdits, AnUnconnectedSupplyFailsWhenItsShapeLosesWire) {
    Level level = wiredLight(0);
    level.lightGroups[0].supplyCell = {10, 30, 2};
    World world;
    world.load(level);
    EXPECT_TRUE(world.applyEdits({test::sphereCarve({2.2, 0.6, 0.3}, 0.2)}).groupsOut.empty()) << "beside the wire";
    EXPECT_TRUE(anyGlow(world));
    EXPECT_EQ(world.applyEdits({test::sphereCarve({1.2, 2.05, 0.6}, 0.2)}).groupsOut.size(), 1u);
    level.lightGroups[0].supplyShape = "gone";
    world.load(level);
    EXPECT_TRUE(world.applyEdits({test::sphereCarve({1.2, 2.05, 0.6}, 0.2)}).groupsOut.empty());
    EXPECT_TRUE(anyGlow(world)) << "without its shape it needs none";
}

LightHandle firstHandle(const World& world) {
    LightHandle first;
    world.lights().forEach([&](LightHandle handle, const Light&) { first = handle; });
    return first;
}

/// A light on the post, above its head.
Light torch(const World& world) {
    return {.name = "torch", .shape = test::firstShape(world), .local = {{0.4, 3.9, 0.4}}, .color = {9.0f, 5.0f, 2.0f}};
}

/// What a step writes to the log.
std::string warningOf(World& world, const Edits& edits) {
    testing::internal::CaptureStderr();
    world.applyEdits(edits);
    return testing::internal::GetCapturedStderr();
}

const CarveEdit kHalfTheHead{.kind = BrushKind::Box, .position = {0.4, 3.85, 0.4}, .halfSize = {1.0, 0.16, 1.0}};

TEST(LightEdits, ALightIsSetAndTheJournalNamesIt) {
    World world;
    world.load(lightPost());
    SetLightEdit edit{firstHandle(world), firstLight(world)};
    edit.values.color = {1.0f, 0.5f, 0.25f};
    edit.values.local.position.y = 2.0;
    edit.values.enabled = false;
    const FrameChanges changes = world.applyEdits({edit});
    EXPECT_EQ(changes.lights, std::vector<LightHandle>{edit.light});
    EXPECT_EQ(firstLight(world).color, edit.values.color);
    EXPECT_EQ(firstLight(world).local.position.y, 2.0);
    EXPECT_FALSE(firstLight(world).enabled);
    EXPECT_EQ(firstLight(world).name, "bulb");
}

TEST(LightEdits, ALightIsAddedOnAShapeAndFallsWithIt) {
    World world;
    world.load(lightPost());
    const FrameChanges added =
        world.applyEdits({AddLightEdit{torch(world)}, AddLightEdit{{.local = {{0.4, 3.9, 0.4}}}}});
    ASSERT_EQ(added.lightsAdded.size(), 2u);
    EXPECT_EQ(added.lights, added.lightsAdded);
    EXPECT_EQ(world.lights().size(), 3u);
    const LightHandle riding = added.lightsAdded[0], free = added.lightsAdded[1];
    EXPECT_EQ(world.lights().at(riding).color, torch(world).color);
    const FrameChanges cut = world.applyEdits({test::sphereCarve({0.4, 1.5, 0.4}, 0.4)});
    ASSERT_EQ(cut.splits.size(), 1u);
    EXPECT_EQ(world.lights().at(riding).shape, cut.splits[0].children[0]);
    EXPECT_FALSE(world.lights().at(free).shape);
    world.setPoses(std::vector<BodyPose>{{world.shapes().at(cut.splits[0].children[0]).body, {{0.0, -1.0, 0.0}}}});
    EXPECT_EQ(lightToWorld(world, world.lights().at(free)).position.y, 3.9);
    EXPECT_LT(lightToWorld(world, world.lights().at(riding)).position.y, 3.9);
}

TEST(LightEdits, ARemovedLightIsGoneAndItsHandleNeverNamesAnother) {
    World world;
    world.load(lightPost());
    const LightHandle bulb = firstHandle(world);
    EXPECT_EQ(world.applyEdits({RemoveLightEdit{bulb}}).lights, std::vector<LightHandle>{bulb});
    EXPECT_EQ(world.lights().size(), 0u);
    EXPECT_NE(warningOf(world, {RemoveLightEdit{bulb}}).find("remove_light: the handle of its light is stale"),
              std::string::npos);
    const LightHandle next = world.applyEdits({AddLightEdit{torch(world)}}).lightsAdded.at(0);
    EXPECT_EQ(next.slot(), bulb.slot());
    EXPECT_FALSE(world.lights().find(bulb));
    EXPECT_TRUE(world.applyEdits({RemoveLightEdit{bulb}, SetLightEdit{bulb, torch(world)}}).lights.empty());
    EXPECT_EQ(world.lights().at(next).name, "torch");
}

TEST(LightEdits, AGroupOutlivesItsLight) {
    World world;
    world.load(lightPost());
    world.applyEdits({RemoveLightEdit{firstHandle(world)}});
    const FrameChanges changes = world.applyEdits({kHalfTheHead});
    EXPECT_EQ(changes.groupsOut.size(), 1u);
    EXPECT_TRUE(changes.lights.empty());
    EXPECT_FALSE(anyGlow(world));
}

TEST(LightEdits, LightsOfAnOutGroupStayDark) {
    World world;
    world.load(lightPost());
    ASSERT_EQ(world.applyEdits({kHalfTheHead}).groupsOut.size(), 1u);
    Light lit = firstLight(world);
    lit.enabled = true;
    const FrameChanges changes = world.applyEdits({SetLightEdit{firstHandle(world), lit}, AddLightEdit{lit}});
    for (const LightHandle light : changes.lights) EXPECT_FALSE(world.lights().at(light).enabled);
    EXPECT_EQ(changes.lights.size(), 2u);
    lit.group = {};
    world.applyEdits({SetLightEdit{firstHandle(world), lit}});
    EXPECT_TRUE(firstLight(world).enabled) << "it left the group";
}

TEST(LightEdits, InvalidLightsAreRefusedWithAReason) {
    World world;
    world.load(lightPost());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto expectRefused = [&](void (*invalidate)(Light&, float), const char* reason) {
        Light light = torch(world);
        invalidate(light, nan);
        world.applyEdits({});
        const uint64_t before = resolvedHash(world);
        for (const Edits& edits : {Edits{AddLightEdit{light}}, Edits{SetLightEdit{firstHandle(world), light}}}) {
            const std::string warning = warningOf(world, edits);
            EXPECT_NE(warning.find(reason), std::string::npos) << warning;
            EXPECT_NE(warning.find("nothing was changed"), std::string::npos) << warning;
            EXPECT_EQ(resolvedHash(world), before) << reason;
        }
    };
    expectRefused([](Light& l, float none) { l.color.g = none; }, "color[1] is nan, expected 0 to 1e+06");
    expectRefused([](Light& l, float) { l.radius = -1.0f; }, "radius is -1, expected 0 to 1000");
    expectRefused([](Light& l, float) { l.reach = std::numeric_limits<float>::infinity(); }, "reach is inf");
    expectRefused([](Light& l, float) { l.coneOuter = 4.0f; }, "cone_outer is 4");
    expectRefused([](Light& l, float none) { l.local.position.x = double(none); }, "position[0] is nan");
    expectRefused([](Light& l, float) { l.local.rotation = {2.0, 0.0, 0.0, 0.0}; }, "length of its rotation is 4");
    expectRefused([](Light& l, float) { l.kind = LightKind(77); }, "kind is 77, expected 0 to 4");
    expectRefused([](Light& l, float) { l.image = {3, {1, 2}}; }, "2 texels in rows of 3");
    expectRefused([](Light& l, float) { l.image = {65, std::vector<uint32_t>(65)}; }, "65 texels in rows of 65");
    expectRefused([](Light& l, float) { l.shape = ShapeHandle::make(l.shape.world(), 9, l.shape.slot()); },
                  "shape is stale");
    expectRefused([](Light& l, float) { l.shape = ShapeHandle::make(77, 1, 0); }, "shape is stale");
    expectRefused([](Light& l, float) { l.group = LightGroupHandle::make(1, 1, 40); }, "light group is stale");
    Light bad = torch(world);
    bad.color.r = nan;
    const FrameChanges changes = world.applyEdits({AddLightEdit{bad}, AddLightEdit{torch(world)}});
    ASSERT_EQ(changes.lightsAdded.size(), 2u) << "one for each edit";
    EXPECT_FALSE(changes.lightsAdded[0]);
    EXPECT_TRUE(world.lights().find(changes.lightsAdded[1]));
}

TEST(LightEdits, LightsAreLimitedToKMaxLights) {
    World world;
    world.load(lightPost());
    const Edits some(4096, AddLightEdit{});
    for (size_t i = 0; i < kMaxLights / some.size(); ++i) world.applyEdits(some);
    EXPECT_EQ(world.lights().size(), kMaxLights);
    EXPECT_NE(warningOf(world, {AddLightEdit{}}).find("expected less than 65536 lights, found 65536"),
              std::string::npos);
    EXPECT_TRUE(world.applyEdits({RemoveLightEdit{firstHandle(world)}, AddLightEdit{torch(world)}}).lightsAdded.at(0));
    EXPECT_EQ(world.lights().size(), kMaxLights);
}

TEST(LightEdits, EveryLightFieldIsHashed) {
    World world;
    world.load(lightPost());
    std::set<uint64_t> seen = {resolvedHash(world)};
    const auto differs = [&](auto&& change) {
        World other = world;
        Light light = firstLight(world);
        change(light);
        other.applyEdits({SetLightEdit{firstHandle(world), light}});
        EXPECT_TRUE(seen.insert(resolvedHash(other)).second) << "change " << seen.size();
    };
    differs([](Light& l) { l.kind = LightKind::Screen; });
    differs([](Light& l) { l.shape = {}; });
    differs([](Light& l) { l.group = {}; });
    differs([](Light& l) { l.local.position.z = 0.5; });
    differs([](Light& l) { l.local.rotation = {0.0, 1.0, 0.0, 0.0}; });
    differs([](Light& l) { l.color.b = 0.5f; });
    for (float Light::*number :
         {&Light::radius, &Light::reach, &Light::coneInner, &Light::coneOuter, &Light::width, &Light::height})
        differs([&](Light& l) { l.*number += 0.25f; });
    differs([](Light& l) { l.twoSided = true; });
    differs([](Light& l) { l.image = {1, {0xff00ffu}}; });
    differs([](Light& l) { l.enabled = false; });
}

TEST(LightEdits, InvalidEnvironmentsChangeNothing) {
    World world;
    world.load(lightPost());
    const Environment before = world.environment();
    SetEnvironmentEdit sky{before}, still{before};
    sky.environment.fogForward = 1.0f;
    still.environment.sunDirection = glm::vec3(0.0f);
    EXPECT_NE(warningOf(world, {sky}).find("fog_forward is 1, expected -0.9 to 0.9"), std::string::npos);
    EXPECT_NE(warningOf(world, {still}).find("sun_direction is zero"), std::string::npos);
    EXPECT_EQ(world.environment(), before);
    EXPECT_FALSE(world.applyEdits({SetEnvironmentEdit{before}}).environmentChanged) << "nothing changed";
}

TEST(LightEdits, TheEnvironmentCanBeEdited) {
    World world;
    world.load(lightPost());
    const uint64_t before = resolvedHash(world);
    SetEnvironmentEdit edit{world.environment()};
    edit.environment.wetness = 0.5f;
    edit.environment.sunDirection = {0.0f, 3.0f, 0.0f};
    EXPECT_TRUE(world.applyEdits({edit}).environmentChanged);
    EXPECT_EQ(world.environment().wetness, 0.5f);
    EXPECT_EQ(world.environment().sunDirection, glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_NE(resolvedHash(world), before);
}

}  // namespace
}  // namespace rubble
