#include <gtest/gtest.h>

#include <set>

#include "generated/paths.h"
#include "runtime/script/functions/vocabulary.h"
#include "samples/lua/examples.h"
#include "samples/lua/reference.h"
#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

const std::string kExamples = RUBBLE_SOURCE_DIR "/samples/lua/examples.lua";

class ExampleTest : public testing::TestWithParam<lua_sample::Example> {};

TEST_P(ExampleTest, DoesWhatItSays) {
    Yard yard;
    EXPECT_EQ(GetParam().name.starts_with("Ui") ? yard.draw(GetParam().text) : yard.run(GetParam().text), "");
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
    const Script& script = yard.host().scripts().front();
    const std::vector<uint64_t>& calls = script.context().calls;
    size_t index = 0, called = 0;
    for (const Subject& subject : vocabulary())
        for (const ScriptFunction& function : subject.functions) {
            if (function.name() == GetParam().name) called = calls.at(index);
            ++index;
        }
    EXPECT_GT(called, 0u) << "the example calls its function";
}

INSTANTIATE_TEST_SUITE_P(Lua, ExampleTest, testing::ValuesIn(lua_sample::readExamples(kExamples)),
                         [](const auto& tested) { return tested.param.name; });

TEST(Vocabulary, EachFunctionHasAnExample) {
    std::set<std::string> functions, examples;
    for (const Subject& subject : vocabulary())
        for (const ScriptFunction& function : subject.functions)
            EXPECT_TRUE(functions.insert(function.name()).second) << function.name();
    for (const auto& example : lua_sample::readExamples(kExamples)) EXPECT_TRUE(examples.insert(example.name).second);
    EXPECT_EQ(functions, examples);
}

TEST(Vocabulary, IsTheListOfTheCompatibleNames) {
    std::set<std::string> functions;
    for (const Subject& subject : vocabulary())
        for (const ScriptFunction& function : subject.functions) functions.insert(function.name());
    std::ifstream list(RUBBLE_SOURCE_DIR "/tests/runtime/script/vocabulary.txt");
    std::string missing;
    size_t count = 0;
    for (std::string line; std::getline(list, line);) {
        if (line.empty() || line[0] == '#') continue;
        ++count;
        const bool isMissing = line.ends_with(" (missing)");
        const std::string name = line.substr(0, line.find(' '));
        EXPECT_EQ(functions.count(name), isMissing ? 0u : 1u) << line;
    }
    EXPECT_GE(count, 150u);
}

TEST(Vocabulary, ThePagesOfTheReferenceAreUpToDate) {
    for (const auto& [name, page] : lua_sample::makeReference(kExamples)) {
        std::ostringstream text;
        text << std::ifstream(RUBBLE_SOURCE_DIR "/docs/scripting/" + name).rdbuf();
        EXPECT_EQ(text.str(), page) << "docs/scripting/" << name << ": ./rubble lua --reference docs/scripting";
    }
}

}  // namespace
}  // namespace rubble::script
