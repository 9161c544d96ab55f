#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "generated/paths.h"
#include "runtime/plugin/c_abi/first_sizes.h"
#include "tests/abi/abi_fixture.h"
#include "tests/abi/run_command.h"

namespace rubble {
namespace {

/// The lines of a layout by their first words: "STRUCT SIZE" and "STRUCT.FIELD OFFSET SIZE".
std::map<std::string, std::string> layoutOf(const std::string& text) {
    std::map<std::string, std::string> out;
    std::istringstream lines(text);
    for (std::string name, rest; lines >> name && std::getline(lines, rest);) out[name] = rest.substr(1);
    return out;
}

std::string run(const char* command) {
    int exitCode = 0;
    std::string text = runCommand(command, exitCode);
    EXPECT_EQ(exitCode, 0) << text;
    return text;
}

TEST(Layout, IsThatOfTheFile) {
    std::ifstream file(RUBBLE_SOURCE_DIR "/tests/abi/layout.txt");
    const std::string written((std::istreambuf_iterator<char>(file)), {});
    EXPECT_EQ(run(RUBBLE_LAYOUT_NOW), written)
        << "a struct may only grow at its end; if that is what happened, write the program's output to layout.txt";
}

TEST(Layout, TheDescriptionHasTheNumbersThatTheHeaderDefines) {
    std::ifstream file(RUBBLE_SOURCE_DIR "/docs/api/rubble.json");
    const std::string json((std::istreambuf_iterator<char>(file)), {});
    const auto has = [&](const char* name, uint64_t value) {
        return json.find(std::string("\"name\": \"") + name + "\",\n   \"value\": " + std::to_string(value)) !=
               std::string::npos;
    };
    EXPECT_TRUE(has("RUBBLE_FILE_ON_DISK", RUBBLE_FILE_ON_DISK));
    EXPECT_TRUE(has("RUBBLE_MAX_BRICK_VERTICES", RUBBLE_MAX_BRICK_VERTICES));
    EXPECT_TRUE(has("RUBBLE_BRICK_BYTES", RUBBLE_BRICK_BYTES));
}

TEST(Layout, KeepsWhatTheFirstReleaseHad) {
    const auto now = layoutOf(run(RUBBLE_LAYOUT_NOW));
    for (const auto& [name, value] : layoutOf(run(RUBBLE_LAYOUT_FIRST))) {
        const auto found = now.find(name);
        ASSERT_NE(found, now.end()) << name;
        if (name.find('.') != std::string::npos)
            EXPECT_EQ(found->second, value) << name;
        else
            EXPECT_GE(std::stoul(found->second), std::stoul(value)) << name;
    }
}

TEST(Layout, TheSmallestSizeOfAStructIsThatOfTheFirstRelease) {
    const auto first = layoutOf(run(RUBBLE_LAYOUT_FIRST)), now = layoutOf(run(RUBBLE_LAYOUT_NOW));
    std::map<std::string, uint32_t> table;
#define RUBBLE_ENTER(type, size) table[#type] = size;
    RUBBLE_FIRST_SIZES(RUBBLE_ENTER)
#undef RUBBLE_ENTER
    for (const auto& [name, value] : now) {
        if (name.find('.') != std::string::npos || name == "rubble_api") continue;
        ASSERT_TRUE(table.contains(name)) << name << " has no line in runtime/plugin/c_abi/first_sizes.h";
        const auto old = first.find(name);
        if (old == first.end())
            EXPECT_LE(table[name], std::stoul(value)) << name;
        else
            EXPECT_EQ(table[name], std::stoul(old->second)) << name;
    }
}

TEST_F(Abi, AHostThatWasBuiltWithTheFirstReleaseWorks) {
    EXPECT_EQ(run((RUBBLE_FIRST_RELEASE_HOST " " + s_level).c_str()), "good\n");
}

/// A host whose rows are longer, as those of a later version would be, and one whose rows are as short as they can be.
TEST_F(Abi, RowsAreAsLargeAsTheHostSays) {
    struct Grown {
        rubble_body_state known;
        uint64_t added;
    };
    auto list = sized<rubble_row_list>();
    list.row_size = sizeof(Grown);
    Grown rows[4] = {};
    rows[0].added = rows[1].added = 7;
    uint32_t count = 0;
    ASSERT_EQ(api()->read_rows(m_world, &list, rows, 4, &count), RUBBLE_OK) << api()->get_last_error();
    const std::vector<rubble_body_state> expected = bodies(m_world);
    ASSERT_EQ(count, expected.size());
    EXPECT_EQ(rows[0].known.body, expected[0].body);
    EXPECT_EQ(rows[0].added, 0u) << "a field that this plugin does not know";
    EXPECT_EQ(rows[1].added, 7u) << "written behind the last row";
    list.row_size = sizeof(rubble_body_state) - 8;
    expectRefused(api()->read_rows(m_world, &list, rows, 4, &count), RUBBLE_ERROR_ARGUMENT, "list->row_size is 112");
    list.row_size = 0;
    for (list.kind = 0; list.kind <= RUBBLE_ROWS_MOVED_BODIES; ++list.kind)
        EXPECT_EQ(api()->read_rows(m_world, &list, nullptr, 0, &count), RUBBLE_OK) << list.kind;
    expectRefused(api()->read_rows(m_world, &list, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT, "list->kind is 10");
}

TEST_F(Abi, RaysAndHitsAreAsLargeAsTheHostSays) {
    struct Ray {
        rubble_ray known;
        uint64_t added;
    } rays[2] = {};
    struct Hit {
        rubble_hit known;
        uint64_t added;
    } hits[2] = {};
    for (int i = 0; i < 2; ++i) {
        rays[i] = {{{0.25, 5.0, 0.25}, {0.0, i ? -1.0 : 1.0, 0.0}, 10.0, 0.0}, 9};
        hits[i].added = 9;
    }
    auto filter = sized<rubble_query_filter>();
    filter.query_size = sizeof(Ray), filter.hit_size = sizeof(Hit);
    ASSERT_EQ(api()->cast_rays(m_world, &rays[0].known, 2, &filter, &hits[0].known), RUBBLE_OK)
        << api()->get_last_error();
    EXPECT_EQ(hits[0].known.hit, 0u);
    EXPECT_EQ(hits[1].known.hit, 1u);
    EXPECT_EQ(hits[1].added, 0u);
    filter.hit_size = 12;
    expectRefused(api()->cast_rays(m_world, &rays[0].known, 2, &filter, &hits[0].known), RUBBLE_ERROR_ARGUMENT,
                  "filter->hit_size is 12");
}

}  // namespace
}  // namespace rubble
