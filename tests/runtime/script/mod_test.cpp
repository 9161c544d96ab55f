#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "generated/paths.h"
#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

const std::string kSamples = RUBBLE_SOURCE_DIR "/samples/lua/mods/";
const std::string kPublic = RUBBLE_SOURCE_DIR "/tests/runtime/script/mods/";

/// Plays a mod for some seconds.
void play(Yard& yard, const std::string& name, int seconds, const std::string& folder = kSamples) {
    std::filesystem::copy_file(kSamples + "car.vox", yard.folder() / "car.vox");
    std::ostringstream text;
    text << std::ifstream(folder + name).rdbuf();
    Script& script = yard.host().add(name, text.str());
    auto view = sized<rubble_view>();
    view.width = 1280, view.height = 720, view.rotation[1] = 1.0, view.position[2] = -8.0;
    for (int i = 0; i < seconds * 60; ++i) {
        yard.host().tick(1.0 / 60.0);
        ASSERT_EQ(yard.host().draw(0, view, 1.0 / 60.0), RUBBLE_OK);
        ASSERT_EQ(yard.host().step(), RUBBLE_OK);
    }
    EXPECT_EQ(script.error(), "");
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
    const std::string lines = text.str();
    if (folder == kSamples) {
        EXPECT_LT(std::count(lines.begin(), lines.end(), '\n'), 100) << "a sample is short";
    }
}

/// A number of the registry.
double number(Yard& yard, const char* key) {
    return std::atof(yard.host().shared().registry[key].c_str());
}

TEST(Mod, TheGravityGunThrowsTheCrate) {
    Yard yard;
    play(yard, "gravity_gun.lua", 3);
    EXPECT_NE(yard.logged(0).find("thrown"), std::string::npos) << yard.logged(0);
    EXPECT_GE(std::stoi(yard.host().shared().registry["gravitygun.speed"]), 8);
}

TEST(Mod, TheNukeBreaksTheYard) {
    Yard yard;
    play(yard, "nuke.lua", 3);
    EXPECT_GT(std::stoi(yard.host().shared().registry["nuke.removed"]), 500);
}

TEST(Mod, TheCleanerDeletesSmallPieces) {
    Yard yard;
    play(yard, "debris_cleaner.lua", 8);
    EXPECT_GT(std::stoi(yard.host().shared().registry["cleaner.deleted"]), 0);
}

TEST(Mod, TheWallCollapses) {
    Yard yard;
    play(yard, "collapse.lua", 6);
    EXPECT_LT(number(yard, "collapse.left"), 0.95);
    EXPECT_FALSE(yard.host().shared().ui.items.empty());
}

TEST(Mod, CarsRain) {
    Yard yard;
    play(yard, "car_rain.lua", 8);
    EXPECT_GT(number(yard, "carrain.hits"), 3);
    EXPECT_GT(number(yard, "carrain.broken"), 20);
}

TEST(Mod, TheLaserCutsADoor) {
    Yard yard;
    play(yard, "laser_cutter.lua", 4);
    EXPECT_GT(number(yard, "laser.removed"), 100);
    EXPECT_EQ(number(yard, "laser.door"), 1);
}

TEST(Mod, TheDroneRamsTheWall) {
    Yard yard;
    play(yard, "wrecking_drone.lua", 12);
    EXPECT_GT(number(yard, "drone.removed"), 100);
}

TEST(Mod, PaintRains) {
    Yard yard;
    play(yard, "paint_rain.lua", 6);
    EXPECT_GT(number(yard, "paintrain.drops"), 100);
}

TEST(Mod, TheLiftGoesUpAndDown) {
    Yard yard;
    play(yard, "lift.lua", 14);
    EXPECT_GT(number(yard, "lift.highest"), 2.0);
    EXPECT_EQ(number(yard, "lift.floor"), 1);
}

TEST(Mod, TheAlarmRunsDown) {
    Yard yard;
    play(yard, "heist_alarm.lua", 8);
    EXPECT_EQ(number(yard, "alarm.on"), 1);
    EXPECT_EQ(number(yard, "alarm.over"), 1);
}

/// The text of a key of the registry.
std::string text(Yard& yard, const char* key) {
    return yard.host().shared().registry[key];
}

// In the style of public mods: globals, tabs, plain tables, no function of ours.

TEST(PublicMod, ATool) {
    Yard yard;
    play(yard, "breaker_tool.lua", 3, kPublic);
    EXPECT_GE(number(yard, "level.shots"), 4);
    EXPECT_GT(yard.host().shared().ui.items.size(), 0u);
}

TEST(PublicMod, ADoorWithAMotor) {
    Yard yard;
    play(yard, "door_opener.lua", 4, kPublic);
    EXPECT_GT(std::abs(number(yard, "level.door.most")), 0.2);
}

TEST(PublicMod, ABlackHole) {
    Yard yard;
    play(yard, "black_hole.lua", 4, kPublic);
    EXPECT_GE(number(yard, "level.blackhole.bodies"), 1);
}

TEST(PublicMod, AFireFighter) {
    Yard yard;
    play(yard, "fire_fighter.lua", 8, kPublic);
    EXPECT_GT(number(yard, "level.fires.most"), 0);
}

TEST(PublicMod, AnArtistOfShapes) {
    Yard yard;
    play(yard, "shape_artist.lua", 1, kPublic);
    EXPECT_NE(text(yard, "level.materials"), "");
    EXPECT_GT(number(yard, "level.art.voxels"), 50);
    EXPECT_LT(number(yard, "level.art.size"), 16);
    EXPECT_EQ(number(yard, "level.art.found"), 1);
}

TEST(PublicMod, AWreckingBall) {
    Yard yard;
    play(yard, "wrecking_ball.lua", 5, kPublic);
    EXPECT_GT(number(yard, "level.wb.hits"), 0);
    const std::string log = yard.logged(0);
    EXPECT_NE(log.find("RegisterTool: this game has none"), log.npos) << log;
    EXPECT_EQ(log.find("PlayLoop"), log.rfind("PlayLoop")) << "told once: " << log;
}

TEST(PublicMod, DemolitionCharges) {
    Yard yard;
    play(yard, "demolition_charges.lua", 4, kPublic);
    EXPECT_GE(number(yard, "level.charges.blown"), 2);
    EXPECT_EQ(text(yard, "level.charges.state"), "done");
}

TEST(PublicMod, ABlinkingLight) {
    Yard yard;
    play(yard, "blinking_light.lua", 4, kPublic);
    EXPECT_EQ(number(yard, "level.light.tagged"), 1);
    for (const char* key : {"level.light.limits", "level.light.other", "level.light.lit", "level.light.crate"})
        EXPECT_EQ(text(yard, key), "1") << key;
    EXPECT_GT(number(yard, "level.light.angle"), 0.2);
}

TEST(PublicMod, Meteors) {
    Yard yard;
    play(yard, "meteor_shower.lua", 5, kPublic);
    EXPECT_GT(number(yard, "level.meteors"), 10);
    EXPECT_NE(text(yard, "level.meteors.last"), "");
}

TEST(PublicMod, ATractorBeam) {
    Yard yard;
    play(yard, "tractor_beam.lua", 6, kPublic);
    EXPECT_GE(number(yard, "level.beam.drops"), 1);
    EXPECT_GT(number(yard, "level.beam.height"), 1.2);
}

TEST(PublicMod, ASlicer) {
    Yard yard;
    play(yard, "slicer.lua", 4, kPublic);
    EXPECT_EQ(text(yard, "level.slicer.error"), "");
    EXPECT_EQ(number(yard, "level.slicer.done"), 1);
    EXPECT_GT(number(yard, "level.slicer.removed"), 100);
    EXPECT_EQ(number(yard, "level.slicer.broken"), 1);
}

TEST(PublicMod, ASwing) {
    Yard yard;
    play(yard, "rope_swing.lua", 3, kPublic);
    EXPECT_GT(number(yard, "level.speed"), 0.5);
    EXPECT_EQ(number(yard, "level.cut"), 1);
}

TEST(PublicMod, ADominoAlarm) {
    Yard yard;
    play(yard, "domino_alarm.lua", 5, kPublic);
    EXPECT_GT(number(yard, "level.domino.sensors"), 2);
    EXPECT_NE(text(yard, "level.domino.first"), "") << "tick() was defined in init()";
    EXPECT_GE(number(yard, "level.domino.level"), 1);
    EXPECT_NE(text(yard, "level.domino.log").find("first s"), std::string::npos);
    EXPECT_GT(number(yard, "level.domino.drawn"), 60) << "draw() was defined in tick()";
    EXPECT_LT(number(yard, "level.domino.drawn"), 130) << "and taken away again";
}

TEST(PublicMod, ANestOfTurrets) {
    Yard yard;
    std::filesystem::copy_file(kPublic + "turret_util.lua", yard.folder() / "turret_util.lua");
    play(yard, "turret_nest.lua", 4, kPublic);
    for (const char* turret : {"1", "2", "3"})
        EXPECT_GE(number(yard, (std::string("level.nest.turret.") + turret + ".shots").c_str()), 8);
    EXPECT_NE(text(yard, "level.nest.materials").find("wood="), std::string::npos)
        << text(yard, "level.nest.materials");
}

TEST(PublicMod, AGremlinAtTheJoints) {
    Yard yard;
    play(yard, "joint_gremlin.lua", 5, kPublic);
    EXPECT_EQ(text(yard, "level.gremlin.hinge"), "HINGE:true");
    EXPECT_EQ(text(yard, "level.gremlin.rope"), "ROPE:true");
    EXPECT_EQ(number(yard, "level.gremlin.opened"), 1);
    EXPECT_GT(number(yard, "level.gremlin.height"), 0.5);
    EXPECT_EQ(number(yard, "level.gremlin.boom"), 1);
    EXPECT_EQ(text(yard, "level.gremlin.mood"), "evil");
    EXPECT_EQ(number(yard, "level.gremlin.left"), 0);
}

}  // namespace
}  // namespace rubble::script
