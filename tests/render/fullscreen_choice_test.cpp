#include "render/shader_library/fullscreen_choice.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

constexpr int kFramesEachWay = FullscreenChoice::kWarmUpFrames + FullscreenChoice::kTimedFrames;

/// A frame of passes, with their milliseconds by fragments and by compute.
struct Cost {
    const char* pass;
    double fragment, compute;
    bool isFullscreen = true;
};
void drawFrame(FullscreenChoice& choice, std::initializer_list<Cost> costs, double disturbance = 0.0) {
    PassTimer::Times times;
    for (const Cost& cost : costs) {
        choice.beginPass(cost.pass);
        const FullscreenMethod method = choice.method();
        if (cost.isFullscreen) choice.recordDraw(method);
        const double milliseconds = method == FullscreenMethod::Compute ? cost.compute : cost.fragment;
        times.push_back({cost.pass, milliseconds + disturbance, int(method)});
    }
    choice.addPassTimes(times);
}

FullscreenMethod chosen(FullscreenChoice& choice, const char* pass) {
    choice.beginPass(pass);
    EXPECT_TRUE(choice.isDecided()) << pass;
    return choice.method();
}

TEST(FullscreenChoice, IsTheRequestedMethod) {
    for (const FullscreenMethod method : {FullscreenMethod::Fragment, FullscreenMethod::Compute}) {
        FullscreenChoice choice(method);
        drawFrame(choice, {{"sun", 1.0, 9.0}});
        EXPECT_EQ(choice.method(), method);
        EXPECT_TRUE(choice.isDecided());
        EXPECT_EQ(choice.takeDecisions(), "");
    }
}

TEST(FullscreenChoice, EachPassKeepsTheFasterMethod) {
    FullscreenChoice choice = FullscreenChoice::fastest();
    for (int frame = 0; frame < 2 * kFramesEachWay; ++frame) {
        EXPECT_EQ(choice.takeDecisions(), "") << "in frame " << frame;
        const bool isFirst = frame < 2 * FullscreenChoice::kWarmUpFrames,
                   isDisturbed = frame == 2 * FullscreenChoice::kWarmUpFrames;
        // The first frames suggest the opposite, and one later frame is an outlier.
        if (isFirst)
            drawFrame(choice, {{"sun", 0.1, 9.0}, {"sky", 9.0, 0.1}, {"gbuffer", 1.0, 1.0, false}});
        else
            drawFrame(choice, {{"sun", 3.0, 2.0}, {"sky", 2.0, 3.0}, {"gbuffer", 1.0, 1.0, false}},
                      isDisturbed ? 50.0 : 0.0);
    }
    EXPECT_EQ(chosen(choice, "sun"), FullscreenMethod::Compute);
    EXPECT_EQ(chosen(choice, "sky"), FullscreenMethod::Fragment);
    EXPECT_EQ(choice.takeDecisions(),
              "sky by fragments (2.000 ms instead of 3.000), sun by compute (2.000 ms instead of 3.000)");
    EXPECT_EQ(choice.takeDecisions(), "") << "a decision is reported once";
}

TEST(FullscreenChoice, ALaterPassIsMeasuredWhenItStarts) {
    FullscreenChoice choice = FullscreenChoice::fastest();
    for (int frame = 0; frame < 2 * kFramesEachWay; ++frame) drawFrame(choice, {{"sun", 3.0, 2.0}});
    EXPECT_NE(choice.takeDecisions().find("sun"), std::string::npos);
    for (int frame = 0; frame < 2 * kFramesEachWay; ++frame) {
        EXPECT_EQ(choice.takeDecisions(), "");
        drawFrame(choice, {{"sun", 1.0, 9.0}, {"fog", 5.0, 4.0}});
    }
    EXPECT_EQ(choice.takeDecisions(), "fog by compute (4.000 ms instead of 5.000)");
    EXPECT_EQ(chosen(choice, "sun"), FullscreenMethod::Compute) << "a decision stays";
}

TEST(FullscreenChoice, FragmentsDrawOnATie) {
    FullscreenChoice choice = FullscreenChoice::fastest();
    for (int frame = 0; frame < 2 * kFramesEachWay; ++frame) drawFrame(choice, {{"sun", 2.0, 2.0}});
    EXPECT_EQ(chosen(choice, "sun"), FullscreenMethod::Fragment);
}

}  // namespace
}  // namespace rubble
