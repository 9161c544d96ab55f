#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/samples/netplay/game.h"

namespace netplay {
namespace {

constexpr LinkSettings kBadLink = {.delay = 6, .loss = 0.05, .seed = 7};  // 100 ms, in each direction

void expectEqualWorlds(Game& game) {
    for (const auto& seat : game.seats()) {
        EXPECT_EQ(seat->client.state(), Client::State::Playing);
        EXPECT_EQ(difference(game.world(), seat->world), "") << "player " << seat->client.player();
        EXPECT_LT(farthestApart(game.world(), seat->world), 2.0 * kPositionError) << "of bodies that rest";
    }
}

void printTraffic(Game& game) {
    for (const auto& seat : game.seats()) {
        const auto& corrections = seat->client.corrections();
        fmt::print("player {}\n{}corrections of poses: p50 {} mm, p99 {} mm\n\n", seat->client.player(),
                   game.server().trafficTo(seat->client.player()).table(), percentile(corrections, 0.5),
                   percentile(corrections, 0.99));
    }
    fmt::print("bodies that move are shown off by p50 {} mm, p90 {} mm, p99 {} mm; the yard has {} bodies\n",
               percentile(game.errors(), 0.5), percentile(game.errors(), 0.9), percentile(game.errors(), 0.99),
               game.world().get_body_states().size());
}

/// Four clients, a fifth that comes in the middle, and one that is away for a while: `seconds` of demolition.
void playWithFour(int seconds) {
    const int steps = seconds * kStepsPerSecond;
    GameSettings settings;
    settings.link = kBadLink;
    Game game(settings);
    for (int i = 0; i < 4; ++i) game.add();
    game.run(steps / 2);
    game.add();
    game.run(steps / 6);
    Seat& lost = *game.seats()[1];
    lost.client.disconnect();
    game.run(steps / 12);
    game.connect(lost);
    game.run(steps / 4);
    ASSERT_TRUE(game.settle());
    expectEqualWorlds(game);
    printTraffic(game);
    EXPECT_EQ(lost.client.snapshots(), 1) << "it went on where it was";
    EXPECT_EQ(game.seats()[4]->client.snapshots(), 1);
    EXPECT_EQ(game.server().dropped(), 0u);
    EXPECT_GT(game.world().get_body_states().size(), size_t(10 * seconds)) << "much was broken";
    for (const auto& seat : game.seats()) {
        EXPECT_LE(game.server().trafficTo(seat->client.player()).medianSecond(), 64'000u);
        EXPECT_LE(percentile(seat->client.corrections(), 0.99), 50);
    }
    EXPECT_LE(percentile(game.errors(), 0.99), 50);
}

TEST(Netplay, FourClientsSeeOneDemolitionOverABadLink) {
    playWithFour(std::getenv("RUBBLE_LONG") ? 120 : 30);
}

TEST(Netplay, APlayerWhoseGameIsForgottenBeginsAgain) {
    Game game({.rows = 1, .stepsBetweenAsks = 30});
    game.add(), game.add();
    game.run(120);
    Seat& seat = *game.seats()[1];
    const uint32_t player = seat.client.player();
    seat.client.disconnect();
    game.run(60);
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER | RUBBLE_WORLD_HOST_PHYSICS;
    seat.world = rubble::World(settings);
    game.connect(seat);
    game.run(120);
    EXPECT_EQ(seat.client.state(), Client::State::Disconnected) << "it has seen that it has another world";
    game.connect(seat);
    ASSERT_TRUE(game.settle());
    EXPECT_EQ(seat.client.player(), player);
    EXPECT_EQ(seat.client.snapshots(), 2);
    expectEqualWorlds(game);
}

TEST(Netplay, AServerThatIsFullSaysSo) {
    Game game({.rows = 1, .players = 2});
    for (int i = 0; i < 3; ++i) game.add();
    game.run(60);
    EXPECT_EQ(game.server().playing(), 2u);
    EXPECT_EQ(game.seats()[2]->client.state(), Client::State::Refused);
}

TEST(Netplay, WhoAsksTooOftenGetsNoMoreAndWhoFloodsIsDropped) {
    Game game({.rows = 1});
    Seat& greedy = game.add();
    greedy.isPlaying = false;
    game.run(30);
    const size_t before = game.world().get_body_states().size();
    for (int i = 0; i < 10; ++i) {
        greedy.client.ask(Tool::Blast, {0.0, 1.0, 0.0});  // at nothing: the next ones come too soon
        greedy.client.ask(Tool::Blast, {-1.0, -0.1, 0.0});
        game.run(1);
    }
    EXPECT_EQ(game.world().get_body_states().size(), before);
    EXPECT_EQ(game.server().dropped(), 0u);
    for (int i = 0; i < 100; ++i) greedy.client.ask(Tool::Blast, {1.0, 0.0, 0.0});
    game.run(30);
    EXPECT_EQ(game.server().dropped(), 1u);
    EXPECT_EQ(greedy.client.state(), Client::State::Disconnected);
}

}  // namespace
}  // namespace netplay
