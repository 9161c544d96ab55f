// The house of docs/editor-house.md, made by the commands of that page.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "generated/paths.h"
#include "tests/editor/editor_level.h"

namespace editor {
namespace {

constexpr size_t kEvening = 7, kCutWire = 8, kBlowHole = 9, kSave = 10;  ///< steps of the page
constexpr const char* kHousePage = RUBBLE_SOURCE_DIR "/docs/editor-house.md";

/// The commands of each step of the page, by its number: the lines of plain blocks below its heading.
std::map<size_t, std::vector<std::string>> houseSteps() {
    std::map<size_t, std::vector<std::string>> steps;
    size_t step = 0;
    bool isCode = false, isCommands = false;
    std::ifstream page(kHousePage);
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("```")) {
            isCode = !isCode;
            isCommands = isCode && line == "```";
        } else if (isCommands) {
            steps[step].push_back(line);
        } else if (!isCode && line.starts_with("## ")) {
            step = size_t(std::atoi(line.c_str() + 3));
        }
    }
    return steps;
}

/// An editor in a folder of its own that has done the first steps of the page.
class HouseDocument : public testing::Test {
protected:
    /// Does a step, whose commands must all work; what its lines `hash` said.
    std::string follow(size_t step) {
        std::string said;
        for (const std::string& line : steps[step]) {
            const Outcome outcome = editor.run(line);
            EXPECT_TRUE(outcome.isDone) << "step " << step << ": " << line << "\n" << outcome.text;
            if (line == "hash") said += outcome.text;
        }
        return said;
    }
    /// Makes the house as it stands in the evening.
    void makeHouse() {
        for (size_t step = 1; step <= kEvening; ++step) follow(step);
        before = editor.document().hash();
    }
    size_t bodies() { return editor.world().get_body_states().size(); }
    uint64_t voxelsOf(const char* name) { return editor.world().get_shape_state(shapeOf(editor, name)).voxel_count; }
    uint32_t groupFlags() {
        const rubble_light_group room = editor.world().find_by_name(RUBBLE_KIND_LIGHT_GROUP, "room").at(0);
        return editor.world().get_light_group(room).flags;
    }
    bool shines() {
        const rubble_light light = editor.world().find_by_name(RUBBLE_KIND_LIGHT, "light").at(0);
        return editor.world().get_light_settings(light).flags & RUBBLE_LIGHT_ENABLED;
    }

    const ExampleFolder folder;
    std::map<size_t, std::vector<std::string>> steps = houseSteps();
    Editor editor;
    uint64_t before = 0;
};

TEST_F(HouseDocument, AllStepsRunAndTheHouseIsSavedAsItWas) {
    std::string hashes;
    ASSERT_EQ(steps.size(), kSave);
    for (size_t step = 1; step <= kSave; ++step) hashes += follow(step);
    const std::string hash = editor.run(std::string("hash")).text;
    EXPECT_EQ(hashes, hash + hash + hash) << "before the plays and after both";
    Editor other;
    runAll(other, {"open house.rubble"});
    EXPECT_EQ(other.document().hash(), editor.document().hash());
}

TEST_F(HouseDocument, StandsWhileNothingActs) {
    makeHouse();
    EXPECT_EQ(editor.run(std::string("components house")).text.find("1 component: 1 anchored, 0 loose"), 0u);
    const std::vector<rubble_body_state> still = editor.world().get_body_states();
    const uint64_t house = voxelsOf("house"), roof = voxelsOf("roof");
    runAll(editor, {"play", "step 120"});
    const std::vector<rubble_body_state> played = editor.world().get_body_states();
    ASSERT_EQ(played.size(), still.size()) << "something broke off";
    for (size_t i = 0; i < still.size(); ++i) {
        ASSERT_EQ(played[i].body, still[i].body);
        for (int a = 0; a < 3; ++a) EXPECT_NEAR(played[i].position[a], still[i].position[a], 0.01) << "body " << i;
        for (int a = 0; a < 4; ++a) EXPECT_NEAR(played[i].rotation[a], still[i].rotation[a], 0.01) << "body " << i;
    }
    EXPECT_EQ(voxelsOf("house"), house);
    EXPECT_EQ(voxelsOf("roof"), roof);
    EXPECT_TRUE(shines());
    runAll(editor, {"stop"});
    EXPECT_EQ(editor.document().hash(), before);
}

TEST_F(HouseDocument, TheLightGoesOutWithItsWire) {
    makeHouse();
    EXPECT_EQ(groupFlags(), uint32_t(RUBBLE_GROUP_ON));
    for (const std::string& line : steps[kCutWire]) {
        if (line.starts_with("carve")) {
            EXPECT_TRUE(shines()) << "it has played until here";
        }
        ASSERT_TRUE(editor.run(line).isDone) << line;
    }
    EXPECT_TRUE(groupFlags() & RUBBLE_GROUP_OUT);
    EXPECT_FALSE(shines());
    runAll(editor, {"stop"});
    EXPECT_EQ(groupFlags(), uint32_t(RUBBLE_GROUP_ON));
    EXPECT_TRUE(shines());
    EXPECT_EQ(editor.document().hash(), before);
}

TEST_F(HouseDocument, TheExplosionBreaksPartsOffAndStopBringsThemBack) {
    makeHouse();
    const size_t count = bodies();
    const uint64_t house = voxelsOf("house");
    follow(kCutWire);
    follow(kBlowHole);  // begins with the end of the play before
    EXPECT_GT(bodies(), count + 50);
    EXPECT_LT(voxelsOf("house"), house - 500);
    runAll(editor, {"stop"});
    EXPECT_EQ(bodies(), count);
    EXPECT_EQ(editor.document().hash(), before);
}

TEST_F(HouseDocument, ItsImagesAreThereAndDrawnByItsCommands) {
    std::vector<std::string> page, script;
    for (const auto& [step, lines] : steps) page.insert(page.end(), lines.begin(), lines.end());
    std::ifstream drawn(RUBBLE_SOURCE_DIR "/samples/editor/house.txt");
    for (std::string line; std::getline(drawn, line);) {
        if (line.empty() || line.starts_with("--") || line.starts_with("ui ")) continue;
        if (const size_t at = line.find("$OUT/"); at != line.npos) line.erase(at, 5);
        script.push_back(line);
    }
    EXPECT_EQ(page, script);
    size_t images = 0;
    std::ifstream text(kHousePage);
    for (std::string line; std::getline(text, line);) {
        if (!line.starts_with("![")) continue;
        const size_t at = line.find("](") + 2;
        const std::string file = line.substr(at, line.find(')', at) - at);
        EXPECT_TRUE(std::filesystem::exists(RUBBLE_SOURCE_DIR "/docs/" + file)) << file;
        ++images;
    }
    EXPECT_GE(images, kSave) << "one a step";
}

}  // namespace
}  // namespace editor
