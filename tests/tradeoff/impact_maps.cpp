#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/physics/scenes/impact_scenes.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/tradeoff/physics_map.h"

namespace rubble::tradeoff {
namespace {

using namespace known;

/// An error as a share, judged and written in per cent.
Judged judgeShare(double error, double stable, double degraded) {
    return judge(error, stable, degraded, fmt::format("{:.2g} %", error * 100.0));
}

Judged judgeShaft(double speed, size_t row, bool) {
    const int ends[] = {1, 2, 5, 10};
    int passed = 0, all = 0;
    for (const int size : {1, 2, 6})
        for (const bool isSnug : {false, true}) ++all, passed += !staysInShaft({}, {size, isSnug, ends[row], speed});
    return judge(double(passed) / all, 0.0, 0.2, fmt::format("{} of {}", passed, all));
}

Judged judgeLedge(double speed, double share) {
    const LedgeHit hit = landOnLedge({}, speed, share);
    return judgeShare(
        std::max(std::abs(hit.spin / hit.expectedSpin - 1.0), std::abs(hit.speed / hit.expectedSpeed - 1.0)), 0.03,
        0.15);
}

Judged judgeBounce(double restitution, double friction) {
    const ObliqueBounce bounce = bounceAslant({}, friction, restitution);
    return judgeShare(
        std::max(std::abs(bounce.up - bounce.expectedUp) / 4.0, std::abs(bounce.lost / bounce.expectedLost - 1.0)),
        0.05, 0.15);
}

Judged judgeBlades(double spin, size_t row, bool) {
    const int posts[] = {1, 2, 4};
    int passed = 0, all = 0;
    for (const bool isHinged : {false, true})
        for (const double at : {0.5, 1.7, 3.7})
            for (const double angle : {0.6, 1.1, 2.6})
                for (const int thickness : {1, 3}) {
                    const Blade blade{
                        spin, isHinged ? 2.0 * at : at, angle, thickness, posts[row], isHinged, isHinged, false, true};
                    ++all, passed += spinBlade({}, blade).passed;
                }
    return judge(double(passed) / all, 0.0, 0.05, fmt::format("{} of {}", passed, all));
}

Judged judgeSpinDown(double spin, const VoxelGrid& grid) {
    const SpinDown down = spinDown(accuratePhysics(), grid, spin);
    return judgeShare(std::abs(down.lost / down.expected - 1.0), 0.04, 0.15);
}

Map spinDownMap() {
    const auto grids = spinDownGrids();
    Map map{"T13-spin-down",
            "things that spin flat on the floor (preset accurate)",
            "angular momentum lost within 4 % of mu m g r; degraded: 15 %",
            "spin, rad/s",
            "rad/s",
            {8, 3, 1},
            {0.5, 0.25},
            "thing",
            {},
            [grids](double spin, size_t row, bool) { return judgeSpinDown(spin, grids[row].second); }};
    for (const auto& [name, grid] : grids) map.rows.push_back(name);
    return map;
}

}  // namespace

std::vector<Map> impactMaps() {
    const std::vector<double> shares{0.1, 0.2, 0.4}, frictions{0.1, 0.2, 0.5};
    return {
        {"T13-shaft",
         "crates thrown along the walls of a shaft at its end",
         "none passes; degraded: one in five",
         "speed, m/s",
         "m/s",
         {5, 10, 20, 60, 150, 300},
         {1000, 3000},
         "end, voxels",
         {"1", "2", "5", "10"},
         judgeShaft},
        {"T13-ledge",
         "a plank that falls flat on a ledge",
         "spin and speed within 3 % of rigid-body impact; degraded: 15 %",
         "speed, m/s",
         "m/s",
         {1, 2.8, 6, 15, 40, 100},
         {300, 1000},
         "share on the ledge",
         namesOf(shares),
         [shares](double speed, size_t row, bool) { return judgeLedge(speed, shares[row]); }},
        {"T13-bounce",
         "a plate that bounces aslant",
         "rises and loses mu (1 + e) v along the floor within 5 %; degraded: 15 %",
         "restitution",
         "",
         {0, 0.25, 0.5, 0.75},
         {0.9, 1},
         "friction",
         namesOf(frictions),
         [frictions](double restitution, size_t row, bool) { return judgeBounce(restitution, frictions[row]); }},
        {"T13-cradle",
         "a Newton's cradle of five that touch",
         "every speed within 2 % of the incoming one; degraded: 10 %",
         "speed, m/s",
         "m/s",
         {30, 10, 3, 1, 0.5},
         {0.25, 0.1},
         "comes in",
         {"1 cube", "3 cubes", "1 ball", "3 balls"},
         [](double speed, size_t row, bool) {
             return judgeShare(cradleError({}, row > 1, row % 2 ? 3 : 1, speed), 0.02, 0.1);
         }},
        {"T13-blade",
         "a blade of 8 m that spins against a post",
         "none passes it; degraded: one in twenty",
         "spin, rad/s",
         "rad/s",
         {10, 30, 60, 100},
         {200, 400},
         "post, voxels",
         {"1", "2", "4"},
         judgeBlades},
        spinDownMap(),
    };
}

}  // namespace rubble::tradeoff
