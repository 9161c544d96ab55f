#include "runtime/core/log.h"

#include <gtest/gtest.h>

#include <future>
#include <string>
#include <thread>
#include <vector>

namespace rubble {
namespace {

using Lines = std::vector<std::string>;

class Log : public testing::Test {
protected:
    void TearDown() override { setLogSink(nullptr, nullptr); }
};

void collect(void* user, LogLevel, std::string_view message) {
    static_cast<Lines*>(user)->emplace_back(message);
}

TEST_F(Log, ASinkMayLog) {
    Lines heard;
    setLogSink(
        [](void* user, LogLevel level, std::string_view message) {
            collect(user, level, message);
            logWarning("from the sink");
        },
        &heard);
    testing::internal::CaptureStderr();
    logInfo("one");
    logInfo("two");
    EXPECT_EQ(heard, (Lines{"one", "two"}));
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "rubble: warning: from the sink\nrubble: warning: from the sink\n");
}

TEST_F(Log, ASinkMaySetAnother) {
    static Lines second;
    second.clear();
    setLogSink([](void*, LogLevel, std::string_view) { setLogSink(collect, &second); }, nullptr);
    logInfo("one");
    logInfo("two");
    EXPECT_EQ(second, Lines{"two"});
}

TEST_F(Log, ASinkMayWaitForAThreadThatLogs) {
    static Lines heard;
    heard.clear();
    setLogSink(
        [](void* user, LogLevel level, std::string_view message) {
            collect(&heard, level, message);
            if (message == "outer") std::thread([] { logInfo("of a thread"); }).join();
            static_cast<void>(user);
        },
        nullptr);
    logInfo("outer");
    EXPECT_EQ(heard, (Lines{"outer", "of a thread"}));
}

TEST_F(Log, MessagesOfManyThreadsComeOneAtATimeAndNoneIsLost) {
    struct Heard {
        int count = 0;
        bool isInside = false;
    } heard;
    setLogSink(
        [](void* user, LogLevel, std::string_view) {
            auto& into = *static_cast<Heard*>(user);
            EXPECT_FALSE(into.isInside);
            into.isInside = true;
            ++into.count;
            into.isInside = false;
        },
        &heard);
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([] {
            for (int k = 0; k < 1000; ++k) logInfo("one of many");
        });
    for (std::thread& thread : threads) thread.join();
    setLogSink(nullptr, nullptr);
    EXPECT_EQ(heard.count, 4000);
}

TEST_F(Log, ASinkThatIsReplacedIsNoLongerCalled) {
    std::promise<void> isInside, mayGo;
    struct Gate {
        std::promise<void>& isInside;
        std::shared_future<void> mayGo;
        bool isGone = false;
    } gate{isInside, mayGo.get_future().share()};
    setLogSink(
        [](void* user, LogLevel, std::string_view) {
            auto& at = *static_cast<Gate*>(user);
            at.isInside.set_value();
            at.mayGo.wait();
            at.isGone = true;
        },
        &gate);
    std::thread logs([] { logInfo("held"); });
    isInside.get_future().wait();
    std::thread opens([&] { mayGo.set_value(); });
    setLogSink(nullptr, nullptr);
    EXPECT_TRUE(gate.isGone) << "the sink was replaced while a thread was in it";
    logs.join();
    opens.join();
}

}  // namespace
}  // namespace rubble
