#include <gtest/gtest.h>

#include "tests/physics/scenes/impact_scenes.h"

namespace rubble {
namespace {

TEST(Blades, NoBladePassesAPost) {
    int passed = 0, gained = 0, missed = 0, all = 0;
    const auto check = [&](const known::Blade& blade) {
        const known::BladeHit hit = known::spinBlade({}, blade);
        ++all, passed += hit.passed, missed += !hit.isHit, gained += !blade.hasMotor && hit.energy > 1.001;
    };
    for (const int kind : {0, 1, 2, 3})  // free; hinged at its end; in its middle; at its end, with a motor
        for (const int post : {1, 2, 4})
            for (const double speed : {10.0, 30.0, 60.0, 80.0, 100.0})
                for (const double at : {0.5, 1.7, 3.0, 3.7})
                    for (const double angle : {0.6, 1.1, 1.7, 2.6})
                        for (const int variant : {0, 1, 2, 3}) {
                            const bool isAtItsEnd = kind % 2 == 1;
                            check({speed, isAtItsEnd ? 2.0 * at : at, angle, variant % 2 ? 3 : 1, post, kind > 0,
                                   isAtItsEnd, kind == 3, variant < 2});
                        }
    EXPECT_EQ(passed, 0) << "of " << all;
    EXPECT_EQ(missed, 0) << "of " << all;
    EXPECT_EQ(gained, 0) << "of " << all;
}

}  // namespace
}  // namespace rubble
