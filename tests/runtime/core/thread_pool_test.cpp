#include "runtime/core/thread_pool.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace rubble {
namespace {

/// Rounds so short that most end before a thread has woken, in between others that do not.
TEST(ThreadPool, CallsEachOnceHoweverShortARoundIs) {
    ThreadPool pool(4);
    for (size_t round = 0; round < 3000; ++round) {
        const size_t count = round % 97 ? round % 5 : 2000;
        std::vector<int> calls(count);
        pool.run(count, [&](size_t i) { ++calls[i]; });
        ASSERT_EQ(calls, std::vector<int>(count, 1)) << "round " << round;
    }
}

TEST(ThreadPool, ThrowsWhatACallHasThrownAndGoesOn) {
    ThreadPool pool(3);
    const auto throwAt = [](size_t at) {
        return [at](size_t i) {
            if (i == at) throw std::runtime_error("of a call");
        };
    };
    for (size_t at = 0; at < 50; ++at) EXPECT_THROW(pool.run(50, throwAt(at)), std::runtime_error);
    EXPECT_NO_THROW(pool.run(50, throwAt(50)));
}

}  // namespace
}  // namespace rubble
