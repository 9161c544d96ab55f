#include <gtest/gtest.h>

#include <cstdio>

#include "tests/runtime/destruction/load_beams.h"

namespace rubble {
namespace {

TEST(LoadAnalysis, CantileverExplore) {
    for (int depth : {4, 5, 8, 12, 16})
        for (int offset : {0, 3, 4, 6})
            for (int length : {40, 80, 160}) {
                LoadFixture f({200, 64, 64});
                f.anchor({{offset, 8 + offset, 8 + offset}, {offset + 4, 8 + offset + depth, 8 + offset + depth}});
                f.fill({{offset + 4, 8 + offset, 8 + offset}, {offset + 4 + length, 8 + offset + depth, 8 + offset + depth}});
                f.solve();
                const double l = length * 0.1, d = depth * 0.1;
                const double expected = 2400 * 9.81 * 3 * l * l / d / 2.6e6;
                const LoadCrack& w = f.analysis.worst();
                printf("d %d off %d l %d: share %.4f / %.4f = %.4f axis %d plane %d cause %d it %d nodes %zu\n", depth, offset, length, w.share, expected,
                       w.share / expected, w.section.axis, w.section.brick.x * 8 + w.section.plane - offset - 4, int(w.cause), f.analysis.iterations(),
                       f.analysis.graph().nodes().size());
            }
}

}  // namespace
}  // namespace rubble
