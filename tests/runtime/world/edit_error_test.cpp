#include "runtime/world/edits/edit_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/core/log.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

using namespace test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(EditError, DefaultEditsAreValid) {
    WorldSettings settings;
    for (const Edit& edit :
         {Edit(CarveEdit{}), Edit(BreakEdit{}), Edit(ExplodeEdit{}), Edit(PaintEdit{}), Edit(SettingsEdit{settings}),
          Edit(HeatEdit{}), Edit(AddCharacterEdit{}), Edit(AddTriggerEdit{}), Edit(SetEnvironmentEdit{}),
          Edit(AddLightEdit{}), Edit(GrabEdit{})})
        EXPECT_EQ(editError(edit), "") << editName(edit);
}

TEST(EditError, NamesTheFirstNumberThatIsOutOfItsRange) {
    WorldSettings settings;
    settings.impactRadius = 100.0;
    Water water{.outline = {{0, 0}, {1, 0}, {0, 1}}};
    water.flow.z = 1e7;
    for (const auto& [edit, expected] :
         {std::pair{Edit(sphereCarve({0.0, std::nan(""), 0.0}, 1.0)), "position[1] is nan, expected -1e+09 to 1e+09"},
          std::pair{Edit(sphereCarve({0.0, 0.0, 0.0}, 1e6)), "radii is 1e+06, expected 0 to 100"},
          std::pair{Edit(ExplodeEdit{.size = 100.0}), "size is 100, expected 0.5 to 4"},
          std::pair{Edit(SettingsEdit{settings}), "impact_radius is 100, expected 0 to 4"},
          std::pair{Edit(AddWaterEdit{water}), "flow[2] is 1e+07, expected -100 to 100"},
          std::pair{Edit(AddWaterEdit{}), "the number of points of the outline is 0, expected 3 to 10000"},
          std::pair{Edit(ImpulseEdit{.impulse = {kInfinity, 0, 0}}), "impulse[0] is inf, expected -1e+16 to 1e+16"},
          std::pair{Edit(WriteVoxelsEdit{.box = {{2'000'000'000, 0, 0}, {-2'000'000'000, 1, 1}}}),
                    "low is 2e+09, expected 0 to 4096"},
          std::pair{Edit(WriteVoxelsEdit{.box = {{0, 0, 0}, {2, 1, 1}}, .entries = {1, 1}, .mask = {1}}),
                    "expected a mask of a byte for each cell of a box"},
          std::pair{Edit(DriveEdit{.brake = -1.0}), "brake is -1, expected 0 to 1"},
          std::pair{Edit(CarveEdit{.kind = BrushKind::Box, .halfSize = {1, 1, 1}, .rotation = {2, 0, 0, 0}}),
                    "the squared length of rotation is 4, expected 0.998 to 1.002"}})
        EXPECT_EQ(editError(edit), expected) << editName(edit);
}

TEST(EditError, PaintIsOfAColourThatTheShapeHas) {
    for (const auto& [paint, expected] : {std::pair{0x10, ""}, std::pair{0x2f, "paint is 2, expected 0 to 1"},
                                          std::pair{0x05, "paint is 16, expected 0 to 1"}}) {
        CreateShapeEdit edit;
        edit.shape.grid = VoxelGrid({8, 8, 8});
        edit.shape.paintColors = std::make_shared<const PaintColors>(PaintColors{.count = 1});
        GridWriter writer(edit.shape.grid);
        writer.set({1, 2, 3}, 1, uint8_t(paint));
        writer.flush();
        EXPECT_EQ(editError(edit), expected) << paint;
    }
}

TEST(EditError, AWorldLeavesInvalidEditsOutAndSaysSo) {
    World world;
    world.load(oneShapeLevel(solidGrid({16, 16, 16}), true));
    world.applyEdits({});
    std::vector<std::string> warnings;
    setLogSink([](void* user, LogLevel,
                  std::string_view text) { static_cast<std::vector<std::string>*>(user)->emplace_back(text); },
               &warnings);
    WorldSettings settings = world.settings();
    settings.stress.contactTime = 0.0;
    const FrameChanges changes =
        world.applyEdits({sphereCarve({0.8, 0.8, 0.8}, -1.0), SettingsEdit{settings}, AddLightEdit{{.radius = -1.0f}}});
    setLogSink(nullptr, nullptr);
    EXPECT_EQ(world.settings().stress.contactTime, StressSettings{}.contactTime);
    EXPECT_EQ(world.shapes().at(firstShape(world)).grid.voxelCount(), 16u * 16u * 16u);
    EXPECT_EQ(changes.lightsAdded, std::vector{LightHandle{}}) << "one row for each edit";
    ASSERT_EQ(warnings.size(), 3u);
    EXPECT_EQ(warnings[0], "carve: radii is -1, expected 0 to 100; nothing was changed");
    EXPECT_EQ(warnings[1], "set_settings: contact_time is 0, expected 0.0001 to 10; nothing was changed");
}

}  // namespace
}  // namespace rubble
