// A player who gets no answer, or no more, hears of it. By steps: nothing here waits for a clock.
#include "samples/netplay/app/participant.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "samples/netplay/enet_transport.h"
#include "samples/netplay/server.h"
#include "samples/netplay/yard.h"

namespace netplay {
namespace {

using Link = Participant::Link;
constexpr int kFiveSeconds = 5 * kStepsPerSecond;

rubble_world_settings without(uint32_t flags) {
    rubble_world_settings settings{};
    settings.flags = RUBBLE_WORLD_NO_RENDERER | flags;
    return settings;
}

Options optionsFor(const Transport& listening) {
    Options options;
    options.host = "127.0.0.1";
    options.port = portOf(listening);
    return options;
}

/// The last of so many steps.
Link tick(Participant& participant, int steps) {
    for (int i = 0; i < steps; ++i) participant.tick(i);
    return participant.link();
}

TEST(Participant, SaysThatThereIsNoAnswer) {
    const auto silent = listenWithEnet(0, 1);  // nobody reads it
    const Options options = optionsFor(*silent);
    Participant participant(options, without(RUBBLE_WORLD_HOST_PHYSICS), 1);
    EXPECT_EQ(tick(participant, kFiveSeconds), Link::Connecting);
    testing::internal::CaptureStderr();
    EXPECT_EQ(tick(participant, 2), Link::NoAnswer);
    const std::string words = testing::internal::GetCapturedStderr();
    EXPECT_NE(words.find("no answer from 127.0.0.1:" + std::to_string(options.port)), std::string::npos) << words;
}

TEST(Participant, JoinsThoughManyHaveConnectedAndSayNothing) {
    rubble::World world(without(0));
    auto listening = listenWithEnet(0, 4);
    const Options options = optionsFor(*listening);
    Server server(world, std::move(listening), {});
    std::vector<std::unique_ptr<Transport>> silent;
    for (int batch = 0; batch < 8; ++batch) {  // in fewer steps than a connection may wait
        for (int i = 0; i < 50; ++i) silent.push_back(connectTo(options, 1));
        Event event;
        for (int round = 0; round < 4; ++round) {
            for (size_t i = silent.size() - 50; i < silent.size(); ++i) silent[i]->tick(), silent[i]->receive(event);
            server.tick();
        }
        EXPECT_EQ(event.kind, Event::Kind::Connected) << batch;
    }
    Participant participant(options, without(RUBBLE_WORLD_HOST_PHYSICS), 1);
    for (int step = 0; step < 60 && participant.link() != Link::Playing; ++step) {
        participant.tick(step);
        server.tick();
    }
    EXPECT_EQ(participant.link(), Link::Playing);
}

TEST(Participant, SaysThatItHasLostTheServer) {
    rubble::World world(without(0));
    buildYard(world, 1);
    auto listening = listenWithEnet(0, 4);
    const Options options = optionsFor(*listening);
    Server server(world, std::move(listening), {});
    Participant participant(options, without(RUBBLE_WORLD_HOST_PHYSICS), 1);
    for (int step = 0; step < 60 && participant.link() != Link::Playing; ++step) {
        participant.tick(step);
        server.tick();
    }
    ASSERT_EQ(participant.link(), Link::Playing);
    EXPECT_EQ(tick(participant, kFiveSeconds - 60), Link::Playing) << "a server may take its time";
    testing::internal::CaptureStderr();
    EXPECT_EQ(tick(participant, 120), Link::Lost);
    EXPECT_EQ(tick(participant, kFiveSeconds), Link::NoAnswer);
    const std::string words = testing::internal::GetCapturedStderr();
    EXPECT_NE(words.find("connection lost to 127.0.0.1"), std::string::npos) << words;
    EXPECT_NE(words.find("no answer from 127.0.0.1"), std::string::npos) << words;
}

TEST(NetplayProgram, SaysWhichNumbersItTakes) {
    const auto said = [](const std::string& options) {
        FILE* pipe = popen((RUBBLE_NETPLAY_PROGRAM " --server --seconds 1 " + options + " 2>&1").c_str(), "r");
        std::string text;
        for (int byte = std::fgetc(pipe); byte != EOF; byte = std::fgetc(pipe)) text += char(byte);
        EXPECT_NE(pclose(pipe), 0) << options;
        return text.substr(0, text.find('\n'));
    };
    EXPECT_EQ(said("--port 70000"), "--port: expected a whole number from 0 to 65535, found \"70000\"");
    EXPECT_EQ(said("--port ''"), "--port: expected a whole number from 0 to 65535, found \"\"");
    EXPECT_EQ(said("--port 0x"), "--port: expected a whole number from 0 to 65535, found \"0x\"");
    EXPECT_EQ(said("--loss nan"), "--loss: expected a number from 0 to 90, found \"nan\"");
}

}  // namespace
}  // namespace netplay
