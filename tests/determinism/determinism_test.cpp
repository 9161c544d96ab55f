// A short version of determinism.sh: one build, few steps.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/determinism/scene_run.h"

namespace rubble {
namespace {

constexpr const char* kTownHash = "045a6de264139d8f";

void expectSameInEveryMode(const std::string& scene, int steps) {
    SceneRun run{.scene = scene, .steps = steps, .every = 10, .threads = 1};
    const Result<Hashes> played = runScene(run);
    ASSERT_TRUE(played) << played.error();
    for (const char* mode : {"load", "replay"}) {
        run.mode = mode;
        run.threads = 3;
        const Result<Hashes> other = runScene(run);
        ASSERT_TRUE(other) << scene << ", " << mode << ": " << other.error();
        EXPECT_EQ(other.value(), played.value()) << scene << ", " << mode;
    }
}

TEST(Determinism, PlayingLoadingAndReplayingAreTheSame) {
    expectSameInEveryMode("pane", 80);
    expectSameInEveryMode("dominoes", 80);
}

/// State hash of the town's demolition. A deliberate change of physics or destruction changes it: then set kTownHash to
/// the new number.
TEST(Determinism, TheTownsHashAfterSixtySteps) {
    const Result<Hashes> hashes = runScene({.scene = "town", .steps = 60, .every = 60, .threads = 1});
    ASSERT_TRUE(hashes) << hashes.error();
    EXPECT_EQ(fmt::format("{:016x}", hashes.value().at(0)), kTownHash);
}

}  // namespace
}  // namespace rubble
