#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "generated/paths.h"
#include "physics/bodies/limits.h"

namespace rubble {
namespace {

std::string row(const char* what, double least, double most) {
    char text[200];
    std::snprintf(text, sizeof text, "| %s | %g | %g |", what, least, most);
    return text;
}

/// OPERATING_ENVELOPE.md is written by ./rubble tradeoff physics --publish, which takes minutes. This compares its
/// limits with the code.
TEST(LimitsDocument, SaysWhatTheCodeClamps) {
    std::ifstream file(RUBBLE_SOURCE_DIR "/OPERATING_ENVELOPE.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
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

}  // namespace
}  // namespace rubble
