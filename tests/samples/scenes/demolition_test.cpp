#include "samples/scenes/demolition.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rubble {
namespace {

constexpr int kSteps = 600;

struct Tally {
    int carves = 0, explosions = 0, paints = 0, impulses = 0;
    double sum = 0.0;  // of all positions, weighted by axis: it changes if any position does
    void add(const Edits& edits) {
        for (const Edit& edit : edits) {
            carves += std::holds_alternative<CarveEdit>(edit);
            explosions += std::holds_alternative<ExplodeEdit>(edit);
            paints += std::holds_alternative<PaintEdit>(edit);
            impulses += std::holds_alternative<ImpulseEdit>(edit);
            std::visit(
                [&](const auto& each) {
                    if constexpr (requires { each.position; })
                        sum += each.position.x + 3.0 * each.position.y + 7.0 * each.position.z;
                },
                edit);
        }
    }
};

Tally townScript(uint64_t seed) {
    Tally tally;
    for (int step = 0; step < kSteps; ++step) tally.add(demolition(step, seed));
    return tally;
}

TEST(Demolition, UsesEveryToolAndStartsUntouched) {
    for (int step = 0; step < 24; ++step) EXPECT_TRUE(demolition(step, 1).empty()) << step;
    const Tally tally = townScript(1);
    EXPECT_GT(tally.paints, 100);
    EXPECT_GT(tally.carves, 30);
    EXPECT_GE(tally.explosions, 6);
    EXPECT_EQ(tally.sum, townScript(1).sum);
    EXPECT_TRUE(std::isfinite(tally.sum));
}

TEST(Demolition, HitsModelsOfAnySize) {
    for (const double size : {0.5, 4.0, 30.0}) {
        Tally tally;
        for (int step = 0; step < kSteps; ++step)
            tally.add(demolishModel(step, {10, 0, 10}, glm::dvec3(10, 0, 10) + size, 1));
        EXPECT_GE(tally.explosions, 6) << size;
        EXPECT_GT(tally.paints, 20) << size;
        EXPECT_TRUE(std::isfinite(tally.sum));
    }
}

TEST(Demolition, CamerasLookAtTheirSubject) {
    for (const double seconds : {0.0, 5.0, 10.0}) {
        const Pose camera = modelCamera({10, 0, 10}, {14, 3, 15}, seconds);
        const glm::dvec3 ahead = camera.inversePoint({12.0, 1.5, 12.5});
        EXPECT_LT(ahead.z, -2.0);
        EXPECT_NEAR(ahead.x, 0.0, 1e-9);
        EXPECT_NEAR(ahead.y, 0.0, 1e-9);
        EXPECT_NEAR(glm::length(demolitionCamera(seconds).rotation), 1.0, 1e-12);
    }
}

}  // namespace
}  // namespace rubble
