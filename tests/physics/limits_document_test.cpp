#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "generated/paths.h"
#include "physics/bodies/limits.h"
#include "tests/tradeoff/light.h"
#include "tests/tradeoff/physics.h"

namespace rubble {
namespace {

std::string row(const char* what, double least, double most) {
    char text[200];
    std::snprintf(text, sizeof text, "| %s | %g | %g |", what, least, most);
    return text;
}

std::string document() {
    std::ifstream file(RUBBLE_SOURCE_DIR "/OPERATING_ENVELOPE.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// OPERATING_ENVELOPE.md is written by ./rubble tradeoff physics --publish, which takes minutes. This compares its
/// limits with the code.
TEST(LimitsDocument, SaysWhatTheCodeClamps) {
    const std::string text = document();
    ASSERT_FALSE(text.empty());
    for (const std::string& line :
         {row("speed, m/s", 0, limits::kMaxSpeed), row("spin, rad/s", 0, limits::kMaxAngularSpeed),
          row("mass of a body, kg", limits::kMinMass, limits::kMaxMass),
          row("distance from the middle of the level, m", 0, limits::kMaxDistance)})
        EXPECT_NE(text.find(line), std::string::npos) << line << "\nrun ./rubble tradeoff physics --publish";
    int maps = 0;
    for (size_t at = text.find("| holds |"); at != std::string::npos; at = text.find("| holds |", at + 1)) ++maps;
    EXPECT_GE(maps, 11) << "only a part of the maps was published";
}

/// Tables are measured one by one, on several machines: publishing some leaves the others with theirs.
TEST(LimitsDocument, EachTableSaysOnWhichMachineItWasMeasured) {
    const std::string text = document();
    const size_t light = text.find("\n# The light\n"), stress = text.find("\n# Stress scenarios\n");
    ASSERT_LT(light, stress);
    const std::string physics = text.substr(0, light), lit = text.substr(light, stress - light);
    for (size_t at = text.find("| holds |"); at != std::string::npos; at = text.find("| holds |", at + 1)) {
        const size_t title = text.rfind("\n## ", at);
        EXPECT_NE(text.substr(title, at - title).find("\nmachine: "), std::string::npos) << text.substr(title, 80);
    }
    EXPECT_EQ(tradeoff::operatingEnvelope({}, physics), physics);
    EXPECT_EQ(tradeoff::lightEnvelope({}, lit), lit);
    tradeoff::Table map{.name = "T13-slope", .title = "a block on a slope", .columns = {"preset"}};
    map.note = "Stable: it stays.", map.stamp = "machine: another";
    map.envelope = {{"fast", "stable up to 1 degree", ""}};
    const std::string after = tradeoff::operatingEnvelope({map}, physics);
    const size_t from = after.find("\n## a block on a slope\n"), next = after.find("\n## ", from + 1);
    EXPECT_EQ(after.substr(from, next - from),
              "\n## a block on a slope\n\nStable: it stays.\n\nmachine: another\n\n| preset | holds |\n| --- | --- |\n"
              "| fast | stable up to 1 degree |\n");
    const size_t was = physics.find("\n## a block on a slope\n"), wasNext = physics.find("\n## ", was + 1);
    EXPECT_EQ(after.substr(next), physics.substr(wasNext));
    EXPECT_EQ(after.substr(0, from), physics.substr(0, was));
}

}  // namespace
}  // namespace rubble
