// Every function with wrong arguments: messages name it and its parameter, and nothing of the interface below.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "runtime/script/functions/vocabulary.h"
#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

constexpr const char* kWrong[] = {"0/0",
                                  "1/0",
                                  "-1",
                                  "0",
                                  "1e30",
                                  "{}",
                                  "true",
                                  "Vec(0/0, 0, 0)",
                                  "Vec(1e30, 0, 0)",
                                  "Vec(2e6, 0, 0)",
                                  "Transform(Vec(1e30, 0, 0))",
                                  "Transform(Vec(), Quat(0, 0, 0, 0))",
                                  "12345",
                                  "FindBody('wall')",
                                  "FindShape('wall')",
                                  "FindLight('bulb')"};

/// A value that a parameter takes, by its name.
std::string rightValue(const std::string& parameter) {
    static const std::map<std::string, std::string> kValues = {{"pos", "Vec(0, 1, -1)"},
                                                               {"origin", "Vec(0, 3, -3)"},
                                                               {"dir", "Vec(0, 0, 1)"},
                                                               {"point", "Vec(0, 1, 0)"},
                                                               {"velocity", "Vec(0, 1, 0)"},
                                                               {"vel", "Vec(0, 1, 0)"},
                                                               {"transform", "Transform(Vec(0, 6, 0))"},
                                                               {"body", "FindBody('crate')"},
                                                               {"shape", "FindShape('crate')"},
                                                               {"other", "FindShape('wall')"},
                                                               {"joint", "FindJoint('hinge')"},
                                                               {"light", "FindLight('bulb')"},
                                                               {"trigger", "FindTrigger('gate')"},
                                                               {"handle", "FindBody('crate')"},
                                                               {"tag", "'crate'"},
                                                               {"file", "'post.vox'"},
                                                               {"min", "Vec(-1, 0, -1)"},
                                                               {"max", "Vec(1, 1, 1)"}};
    const auto found = kValues.find(parameter);
    return found == kValues.end() ? "0.5" : found->second;
}

/// Calls with one wrong argument each. Those behind it are left out, or right.
std::set<std::string> wrongCalls(const ScriptFunction& function) {
    std::set<std::string> calls;
    const std::vector<std::string> parameters = function.parameters();
    for (size_t wrong = 0; wrong < parameters.size(); ++wrong)
        for (const char* value : kWrong) {
            std::string arguments;
            for (size_t i = 0; i < parameters.size(); ++i) {
                const std::string right = rightValue(parameters[i]);
                const bool isLeftOut = i > wrong && right == "0.5";
                arguments += (i ? ", " : "") + (i == wrong ? std::string(value) : isLeftOut ? "nil" : right);
            }
            calls.insert(function.name() + "(" + arguments + ")");
        }
    return calls;
}

/// What a call has an error or a warning of, without script and line; "": nothing.
std::string messageOf(Yard& yard, const std::string& call) {
    std::string told;
    ScriptHostSettings settings;
    settings.folder = yard.folder().string();
    settings.log = [&](int level, const std::string& line) {
        if (level >= RUBBLE_LOG_WARNING && told.empty()) told = line.substr(line.find(": ") + 2);
    };
    ScriptHost host(yard.api(), yard.world(), settings);
    const bool draws = call.starts_with("Ui");
    host.add("test", std::string("function ") + (draws ? "draw" : "init") + "() " + call + " end");
    if (draws) host.draw(0, viewOf(960, 540), 1.0 / 60.0);
    return told;
}

class MessageTest : public testing::TestWithParam<const Subject*> {};

TEST_P(MessageTest, NamesAParameterOfTheFunction) {
    static const std::regex kOfInterface("[a-z]_[a-z]|->|\\[[0-9]|RUBBLE|bad argument|/");
    Yard yard;
    size_t messages = 0;
    for (const ScriptFunction& function : GetParam()->functions) {
        const std::vector<std::string> parameters = function.parameters();
        const std::string name = function.name() + ": ";
        if (function.name() == "start" || function.name() == "require") continue;  // of no numbers
        for (const std::string& call : wrongCalls(function)) {
            const std::string message = messageOf(yard, call);
            if (message.empty()) continue;
            ++messages;
            EXPECT_TRUE(message.starts_with(name)) << call << ": " << message;
            const std::string text = message.substr(std::min(name.size(), message.size()));
            EXPECT_FALSE(std::regex_search(text, kOfInterface)) << call << ": " << message;
            const std::string first = text.substr(0, text.find_first_of(": "));
            const bool isNamed = std::find(parameters.begin(), parameters.end(), first) != parameters.end();
            EXPECT_TRUE(isNamed || first == "expected" || first == "this") << call << ": " << message;
        }
    }
    RecordProperty("messages", int(messages));
}

std::vector<const Subject*> subjects() {
    std::vector<const Subject*> all;
    for (const Subject& each : vocabulary()) all.push_back(&each);
    return all;
}

INSTANTIATE_TEST_SUITE_P(Script, MessageTest, testing::ValuesIn(subjects()), [](const auto& tested) {
    std::string name(tested.param->name);
    std::replace_if(
        name.begin(), name.end(), [](char each) { return !std::isalnum(uint8_t(each)); }, '_');
    return name;
});

}  // namespace
}  // namespace rubble::script
