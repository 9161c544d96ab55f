#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "generated/paths.h"

namespace rubble {
namespace {

std::string textOf(const char* path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// docs/ranges.md is for those who do not read the header: each range of the one is a row of the other.
TEST(RangesDocument, HasTheRangesOfTheHeader) {
    const std::string header = textOf(RUBBLE_SOURCE_DIR "/runtime/core/ranges.h"),
                      document = textOf(RUBBLE_SOURCE_DIR "/docs/ranges.md");
    const std::regex range(R"(constexpr NumberRange k(\w+)\{([^,]+), ([^}]+)\};)");
    int rows = 0;
    for (auto at = std::sregex_iterator(header.begin(), header.end(), range); at != std::sregex_iterator(); ++at) {
        std::string low = (*at)[2], high = (*at)[3];
        std::erase(low, '\''), std::erase(high, '\'');
        const std::string row = "| " + (*at)[1].str() + " | " + low + " | " + high + " |";
        EXPECT_NE(document.find(row), std::string::npos) << "docs/ranges.md lacks: " << row;
        ++rows;
    }
    EXPECT_GT(rows, 50);
}

}  // namespace
}  // namespace rubble
