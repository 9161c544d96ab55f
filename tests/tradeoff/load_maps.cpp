#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/physics/scenes/load_scenes.h"
#include "tests/tradeoff/physics.h"
#include "tests/tradeoff/physics_map.h"

namespace rubble::tradeoff {
namespace {

using namespace known;

Judged judgeDraught(double density, glm::ivec3 size) {
    const double off = std::abs(floatInShallowWater({}, size, uint32_t(density)) / (density / 1000.0) - 1.0);
    return judge(off, 0.03, 0.1, fmt::format("{:.2g} %", off * 100.0));
}

Judged judgeWinding(double speed, double mass, bool full) {
    const Winding wound = windRope({}, 9.81, 4, mass, speed, full ? 1200 : 600);
    const double share = wound.gained / std::max(wound.lost, 0.01 * mass);
    return judge(share, 1e-3, 1e-2, fmt::format("{:.1g}", share));
}

/// 80 kg hold a plank whose middle lies 1 m behind the edge up to mass / 80 m beyond the edge.
Judged judgePlank(double mass, size_t row, bool) {
    const PhysicsSettings& settings = presets()[row].settings;
    const double limit = mass / 80.0;
    const auto sinks = [&](double beyond) {
        PlankWalk walk(settings, mass);
        walk.load();
        walk.seconds(3.0);
        return walk.walkTo(beyond) > 0.05;
    };
    const bool holds = !sinks(limit - 0.1), tips = sinks(limit + 0.15);
    return {holds && tips ? Outcome::Stable : Outcome::Failed,
            fmt::format("{}\n{}", holds ? "holds" : "tips early", tips ? "tips" : "holds too long")};
}

}  // namespace

std::vector<Map> loadMaps() {
    const std::vector<double> masses{1, 122, 1000};
    const std::vector<glm::ivec3> sizes{{1, 1, 1}, {2, 1, 1}, {3, 1, 2}, {2, 2, 2}, {8, 1, 1}};
    return {
        {"T13-float",
         "small things that float in 0.3 m of water",
         "the share in the water within 3 % of density; degraded: 10 %",
         "density, kg/m3",
         "kg/m3",
         {500, 600, 800, 900, 300, 200},
         {950, 100, 50},
         "voxels",
         {"1", "2x1x1", "3x1x2", "2x2x2", "8x1x1"},
         [sizes](double density, size_t row, bool) { return judgeDraught(density, sizes[row]); }},
        {"T13-winding",
         "a load on a rope that winds round a pole",
         "gains at most 0.1 % of what it lost; degraded: 1 %",
         "speed, m/s",
         "m/s",
         {1, 3, 10, 30},
         {60, 100},
         "load, kg",
         namesOf(masses),
         [masses](double speed, size_t row, bool full) { return judgeWinding(speed, masses[row], full); }},
        {"T13-plank",
         "80 kg that walk beyond the edge on a plank",
         "it holds up to 10 cm before the balance and tips 15 cm behind it",
         "plank, kg",
         "kg",
         {75, 100, 50, 30},
         {20},
         "preset",
         presetNames(),
         judgePlank},
    };
}

}  // namespace rubble::tradeoff
