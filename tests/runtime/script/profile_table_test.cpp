#include "runtime/script/profile_table.h"

#include <gtest/gtest.h>

#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

constexpr const char* kBusy =
    "function update() for i = 1, 4 do GetTime() end end\n"
    "function draw() for i = 1, 1000 do VecAdd({1, 2, 3}, {1, 2, 3}) end end\n"
    "function init() while true do wait(0) end end";

/// Plays some frames.
void play(Yard& yard, int frames) {
    auto view = sized<rubble_view>();
    view.width = 1280, view.height = 720, view.rotation[3] = 1.0;
    for (int i = 0; i < frames; ++i) {
        yard.host().tick(1.0 / 60.0);
        yard.host().draw(0, view, 1.0 / 60.0);
        yard.host().step();
    }
}

/// The texts that are drawn, a line each.
std::string shown(Yard& yard) {
    std::string text;
    for (const UiItem& item : yard.host().shared().ui.items) text += item.text + "\n";
    return text;
}

TEST(ProfileTable, ShowsWhatScriptsCost) {
    Yard yard;
    yard.host().add("busy.lua", kBusy);
    yard.host().add("idle.lua", "function tick() end");
    yard.host().shared().showsProfile = true;
    play(yard, 1 + 2 * ProfileTable::kFrames);
    const std::string text = shown(yard);
    const auto at = [&](const std::string& line) {
        EXPECT_NE(text.find(line), text.npos) << line << " in\n" << text;
        return text.find(line);
    };
    const size_t busy = at("busy.lua                        3.0");
    const size_t draw = at("  draw                          1.0"), add = at("  VecAdd                     1000.0");
    const size_t update = at("  update                        1.0"), time = at("  GetTime                       4.0");
    const size_t wait = at("  (after wait)                  1.0");
    const size_t idle = at("idle.lua                        1.0");
    EXPECT_LT(at("script  "), busy);
    EXPECT_LT(busy, draw);
    EXPECT_LT(draw, add) << "the costliest is first";
    EXPECT_LT(add, std::min({update, time, wait}));
    EXPECT_LT(std::max({update, time, wait}), idle);
    EXPECT_EQ(text.find("Explosion"), text.npos) << "what was not called is not there";
}

TEST(ProfileTable, ManyScriptsAreCutOff) {
    Yard yard;
    for (int i = 0; i < 100; ++i) yard.host().add("script" + std::to_string(i), "function tick() end");
    yard.host().shared().showsProfile = true;
    play(yard, 1 + ProfileTable::kFrames);
    EXPECT_NE(shown(yard).find("... 171 more"), std::string::npos) << shown(yard);
    EXPECT_LE(yard.host().shared().ui.items.size(), ProfileTable::kMaxRows + 2);
}

TEST(ProfileTable, FollowsScriptsThatEndAndBegin) {
    Yard yard;
    yard.host().add("first.lua", kBusy);
    yard.host().shared().showsProfile = true;
    play(yard, 1 + ProfileTable::kFrames);
    EXPECT_TRUE(yard.host().reload("first.lua", "function tick() GetTime() end"));
    yard.host().add("second.lua", "function tick() end");
    play(yard, ProfileTable::kFrames);
    EXPECT_NE(shown(yard).find("second.lua                      1.0"), std::string::npos) << shown(yard);
    EXPECT_NE(shown(yard).find("  GetTime                       1.0"), std::string::npos) << shown(yard);
    yard.host().scripts().clear();
    play(yard, ProfileTable::kFrames);
    EXPECT_EQ(shown(yard).find(".lua"), std::string::npos) << shown(yard);
}

TEST(ProfileTable, CostsNothingUnlessItIsShown) {
    Yard yard;
    Script& script = yard.host().add("busy.lua", kBusy);
    play(yard, 40);
    const size_t items = yard.host().shared().ui.items.size();
    EXPECT_EQ(items, 0u);
    EXPECT_TRUE(script.context().costs.empty()) << "nobody looks at the time of functions";
    yard.host().add("show.lua", "function init() DebugProfile(true) wait(0.5) DebugProfile(false) end");
    play(yard, 10);
    EXPECT_GT(yard.host().shared().ui.items.size(), 0u);
    EXPECT_EQ(script.context().costs.size(), script.context().calls.size());
    play(yard, 40);
    EXPECT_EQ(yard.host().shared().ui.items.size(), 0u);
    EXPECT_TRUE(script.context().costs.empty());
}

}  // namespace
}  // namespace rubble::script
