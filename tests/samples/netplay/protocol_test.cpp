#include "samples/netplay/protocol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "samples/netplay/pose_track.h"

namespace netplay {
namespace {

std::vector<BodyPose> somePoses(int count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    std::vector<BodyPose> out;
    for (int i = 0; i < count; ++i) {
        BodyPose pose;
        pose.id = out.empty() ? 7 : out.back().id + 1 + random() % 40;
        pose.position = {100.0 * part(random), 30.0 * part(random), 100.0 * part(random)};
        double length = 0.0;
        for (double& value : pose.rotation) value = part(random), length += value * value;
        for (double& value : pose.rotation) value /= std::sqrt(length);
        pose.isAsleep = random() % 2;
        out.push_back(pose);
    }
    return out;
}

/// The angle between two rotations, radians.
double angle(const Quat& a, const Quat& b) {
    double dot = 0.0;
    for (size_t i = 0; i < 4; ++i) dot += a[i] * b[i];
    return 2.0 * std::acos(std::min(std::abs(dot), 1.0));
}

TEST(Protocol, PosesAreReadAsTheyWereWithinMillimetres) {
    Poses message;
    message.bodies = somePoses(80);
    message.players = {{3, {1.0, 2.0, 3.0}}, {9, {-5.0, 2.0, 7000.0}}};
    const std::vector<uint8_t> bytes = encode(message);
    EXPECT_LT(bytes.size(), kPosePacketBytes);
    const auto read = decode(bytes, false);
    ASSERT_TRUE(read);
    const auto& got = std::get<Poses>(*read);
    ASSERT_EQ(got.bodies.size(), message.bodies.size());
    for (size_t i = 0; i < got.bodies.size(); ++i) {
        const BodyPose &is = got.bodies[i], &was = message.bodies[i];
        EXPECT_EQ(is.id, was.id);
        EXPECT_EQ(is.isAsleep, was.isAsleep);
        for (size_t axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(is.position[axis], was.position[axis], kPositionError + 1e-9);
        EXPECT_LT(angle(is.rotation, was.rotation), 0.004);
    }
    EXPECT_NEAR(got.players[1].position[2], 7000.0, 0.001);
}

TEST(Protocol, MessagesAreReadAsTheyWere) {
    EditSteps steps;
    steps.last = 900;
    steps.names = {{4, 0x0102030405060708, 898}, {9, 1, 900}};
    steps.deltas = {{1, 2, 3}, {}, std::vector<uint8_t>(5000, 7)};
    const auto read = decode(encode(steps), false);
    ASSERT_TRUE(read);
    const auto& got = std::get<EditSteps>(*read);
    EXPECT_EQ(got.deltas, steps.deltas);
    ASSERT_EQ(got.names.size(), 2u);
    EXPECT_EQ(got.names[0].handle, steps.names[0].handle);
    EXPECT_EQ(got.names[0].step, 898u);
    EXPECT_LT(encode(steps).size(), 100u) << "packed";
    const auto join = decode(encode(Join{kVersion, 1, 2, 3}), true);
    ASSERT_TRUE(join);
    EXPECT_EQ(std::get<Join>(*join).step, 3u);
}

TEST(Protocol, WhatIsNotExactlyAMessageIsRefused) {
    const std::vector<Message> messages = {Join{},    Input{}, Ask{Tool::Push, {1, 2, 3}},
                                           Welcome{}, Poses{}, EditSteps{}};
    for (const Message& message : messages) {
        const bool isFromClient = message.index() < 3;
        std::vector<uint8_t> bytes = encode(message);
        EXPECT_TRUE(decode(bytes, isFromClient)) << message.index();
        EXPECT_FALSE(decode(bytes, !isFromClient)) << "only the other end sends it";
        for (size_t size = 0; size < bytes.size(); ++size)
            EXPECT_FALSE(decode(std::span(bytes).first(size), isFromClient)) << message.index() << " " << size;
        bytes.push_back(0);
        EXPECT_FALSE(decode(bytes, isFromClient)) << message.index();
    }
    EXPECT_FALSE(decode(encode(Ask{Tool(9), {1, 0, 0}}), true));
    EXPECT_FALSE(decode(encode(Ask{Tool::Blast, {}}), true)) << "no direction";
}

TEST(PoseTrack, InterpolatesWaitsForItsBodyToWakeAndGoesOnForATenthOfASecond) {
    PoseTrack track;
    BodyPose pose;
    EXPECT_FALSE(track.at(5.0));
    track.add(10, pose);
    pose.position[0] = 1.0;
    track.add(14, pose);
    EXPECT_FALSE(track.at(9.0)) << "nothing is known of then";
    EXPECT_NEAR(track.at(12.0)->position[0], 0.5, 1e-12);
    EXPECT_NEAR(track.at(16.0)->position[0], 1.5, 1e-12) << "as it moved";
    EXPECT_NEAR(track.at(99.0)->position[0], 2.5, 1e-12) << "no farther than six steps";
    pose.isAsleep = true, pose.position[0] = 1.25;
    track.add(18, pose);
    EXPECT_TRUE(track.isAtRest(18.0));
    EXPECT_NEAR(track.at(99.0)->position[0], 1.25, 1e-12);
    pose.isAsleep = false, pose.position[0] = 2.25;
    track.add(118, pose);
    EXPECT_NEAR(track.at(114.0)->position[0], 1.25, 1e-12) << "it slept until a moment before";
    EXPECT_NEAR(track.at(116.5)->position[0], 1.75, 1e-12);
    track.add(118, BodyPose{});
    EXPECT_NEAR(track.at(118.0)->position[0], 2.25, 1e-12) << "known already";
}

}  // namespace
}  // namespace netplay
