#include "runtime/core/mailbox.h"

#include <gtest/gtest.h>

#include <thread>

namespace rubble {
namespace {

TEST(Mailbox, DeliversInOrderAcrossThreads) {
    Mailbox<int> box;
    std::thread writer([&] {
        for (int i = 0; i < 10000; ++i) box.post(i);
        box.close();
    });
    int expected = 0;
    while (const auto value = box.take()) ASSERT_EQ(*value, expected++);
    writer.join();
    EXPECT_EQ(expected, 10000);
    EXPECT_FALSE(box.tryTake());
    box.post(1);
    EXPECT_EQ(box.size(), 0u) << "closed";
}

}  // namespace
}  // namespace rubble
