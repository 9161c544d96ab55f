#include <gtest/gtest.h>

#include "tests/runtime/script/attacks.h"
#include "tests/runtime/script/lua_run.h"

namespace rubble::script {
namespace {

constexpr size_t kReserve = 64 << 10;  ///< bytes above the limit with which an error is told

SandboxLimits smallLimits() {
    SandboxLimits limits;
    limits.memory = 4 << 20;
    limits.work = 300'000;
    limits.processorSeconds = 1.0;  // what stops most of them is their count, under sanitizers too
    return limits;
}

class AttackTest : public testing::TestWithParam<Attack> {};

TEST_P(AttackTest, IsHeldByTheSandbox) {
    const Attack& attack = GetParam();
    Sandbox box(smallLimits());
    const std::string answer = runText(box, attack.text);
    const std::string outcome = box.isStopped() ? "stopped" : answer.starts_with("error: ") ? "fails" : "ends";
    EXPECT_EQ(outcome, attack.outcome) << answer;
    EXPECT_LE(box.workUsed(), 2 * box.limits().work);
    EXPECT_LE(box.peakMemory(), box.limits().memory + kReserve);
    if (box.isStopped()) {
        EXPECT_NE(answer.find("was stopped"), std::string::npos) << answer;
        EXPECT_EQ(runText(box, "return 1"), "error: " + box.stopReason());
    } else {
        EXPECT_EQ(runText(box, "return 1"), "1") << "after an error a script goes on";
    }
}

INSTANTIATE_TEST_SUITE_P(Lua, AttackTest, testing::ValuesIn(readAttacks()), [](const auto& tested) {
    std::string name;
    for (const char byte : tested.param.name) name += std::isalnum(static_cast<unsigned char>(byte)) ? byte : '_';
    return name;
});

TEST(Attack, ThereAreAHundred) {
    EXPECT_GE(readAttacks().size(), 100u);
}

}  // namespace
}  // namespace rubble::script
