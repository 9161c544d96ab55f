#include "samples/netplay/link_conditioner.h"

#include <gtest/gtest.h>

#include "samples/netplay/memory_transport.h"

namespace netplay {
namespace {

/// Sends 1,000 messages with their numbers over a link; what arrives, and in which step.
std::vector<std::pair<int, int>> sendThousand(Delivery delivery, const LinkSettings& settings) {
    MemoryNetwork network;
    const auto server = network.listen();
    LinkConditioner client(network.connect(), settings);
    std::vector<std::pair<int, int>> out;
    Event event;
    for (int step = 0; step < 2000; ++step) {
        const auto number = uint16_t(step);
        if (step < 1000) client.send(0, delivery, {reinterpret_cast<const uint8_t*>(&number), sizeof number});
        client.tick();
        while (server->receive(event))
            if (event.kind == Event::Kind::Received) out.emplace_back(event.bytes[0] | event.bytes[1] << 8, step);
    }
    return out;
}

TEST(LinkConditioner, LosesAPartOfUnreliableMessagesAndDelaysTheOthersEqually) {
    const auto arrived = sendThousand(Delivery::Unreliable, {.delay = 6, .loss = 0.05, .seed = 3});
    EXPECT_NEAR(double(arrived.size()), 950.0, 25.0);
    for (const auto& [number, step] : arrived) EXPECT_EQ(step - number, 6);
    EXPECT_EQ(arrived, sendThousand(Delivery::Unreliable, {.delay = 6, .loss = 0.05, .seed = 3})) << "the same again";
}

TEST(LinkConditioner, BringsReliableMessagesInOrderLostOnesLater) {
    const auto arrived = sendThousand(Delivery::Reliable, {.delay = 6, .loss = 0.05, .seed = 3});
    ASSERT_EQ(arrived.size(), 1000u);
    int late = 0;
    for (int i = 0; i < 1000; ++i) {
        EXPECT_EQ(arrived[size_t(i)].first, i);
        late += arrived[size_t(i)].second - i > 6;
    }
    EXPECT_GT(late, 50) << "those behind a lost one wait too";
}

}  // namespace
}  // namespace netplay
