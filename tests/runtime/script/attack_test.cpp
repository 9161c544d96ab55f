#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdlib>

#include "tests/runtime/script/attacks.h"
#include "tests/runtime/script/lua_run.h"
#include "tests/runtime/script/yard_fixture.h"

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

/// Bytes that the process holds.
size_t bytesInUse() {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

/// With RUBBLE_LONG 10,000 rounds: scripts of a sandbox alone, and of a world.
TEST(Attack, NothingLeaks) {
    const std::vector<Attack> attacks = readAttacks();
    const size_t rounds = std::getenv("RUBBLE_LONG") ? 10'000 : 1000;
    SandboxLimits limits = smallLimits();
    limits.memory = 1 << 20, limits.work = 30'000;
    Yard yard(limits);
    size_t before = 0;
    for (size_t i = 0; i < rounds; ++i) {
        const Attack& attack = attacks[i % attacks.size()];
        {
            Sandbox box(limits);
            runText(box, attack.text);
        }
        yard.host().add("attack", "function init() " + attack.text + "\nend");
        if (i % 20 == 0) yard.host().step();
        yard.host().scripts().clear();
        if (i == rounds / 2) before = bytesInUse();
    }
    EXPECT_LE(bytesInUse(), before + (64 << 10)) << before << " bytes after half of the rounds";
}

TEST(Attack, ThereAreAHundred) {
    EXPECT_GE(readAttacks().size(), 100u);
}

}  // namespace
}  // namespace rubble::script
