#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/physics/scenes/known_scenes.h"
#include "tests/tradeoff/physics.h"
#include "tests/tradeoff/physics_map.h"

namespace rubble::tradeoff {
namespace {

using namespace known;

Judged judgeSpin(double spin, size_t row, bool full) {
    const int lengths[] = {1, 4, 16, 64};
    const FreeSpin free = spinFreely({}, solidGrid({lengths[row], 1, 1}, 7),
                                     glm::normalize(glm::dvec3(1, 0.9, 0.3)) * spin, full ? 60.0 : 10.0);
    return judge(std::max(free.energy, free.momentum * 100.0), 1e-3, 0.1,
                 fmt::format("E {:.0e}\nL {:.0e}", free.energy, free.momentum));
}

Judged judgeStack(double cubes, size_t row, bool full) {
    const Tower tower = stack(sleepless(presets()[row].settings), int(cubes), full ? 30.0 : 10.0);
    const std::string text = fmt::format("{:.1f} mm", tower.lower * 1e3);
    return tower.stands() ? judge(tower.lower, 0.02, 0.25, text) : Judged{Outcome::Failed, "falls"};
}

Judged judgeSmallStack(double cubes, double voxelSize) {
    const double farthest = farthestInStack({}, voxelSize, int(cubes));
    return judge(farthest, 1.0, 2.0, fmt::format("{:.2g} voxels", farthest));
}

Judged judgeRatio(const PhysicsSettings& settings, double ratio) {
    const double deep = sink(settings, ratio);
    return judge(deep, 0.01, 0.05, fmt::format("{:.1f} mm", deep * 1e3));
}

Judged judgeRest(double voxelSize, double gravity, glm::ivec3 size) {
    const double speed = unrest({}, voxelSize, size, gravity), scale = std::max(1.0, voxelSize / 0.1);
    return judge(speed, 1e-3 * scale, 1e-2 * scale, fmt::format("{:.2g} mm/s", speed * 1e3));
}

Judged judgeShots(double speed, size_t row, bool full) {
    const int thickness[] = {1, 2, 4};
    const Shots shots = shoot({}, full ? 500 : 60, 1, speed, 0.8 * speed, thickness[row]);
    return judge(double(shots.through) / shots.fired, 0.0, 0.02, fmt::format("{} of {}", shots.through, shots.fired));
}

/// Tries several places at the distance: whether rounding changes a decision, such as when to sleep, is chance.
Judged judgeDistance(double km, size_t row, bool) {
    constexpr int kSites = 8;
    const std::vector<glm::dvec3> here = tumble(presets()[row].settings, glm::dvec3(0.0));
    std::vector<double> off;
    for (int site = 0; site < kSites; ++site) {
        const double far = km * 1e3 * (1.0 + 0.0137 * site);
        const std::vector<glm::dvec3> there = tumble(presets()[row].settings, {far, 0, far * 0.625});
        off.push_back(0.0);
        for (size_t i = 0; i < here.size(); ++i) off.back() = std::max(off.back(), glm::length(here[i] - there[i]));
    }
    return judge(quantile(off, 1.0), 1e-3, 1e-2,
                 fmt::format("{:.2g} mm\nmax {:.2g}", quantile(off, 0.5) * 1e3, quantile(off, 1.0) * 1e3));
}

Judged judgeIncline(double degrees, double friction) {
    const double angle = glm::radians(degrees), expected = 9.81 * (std::sin(angle) - friction * std::cos(angle));
    const Slide slide = slideDown({}, degrees, 0.57, friction, 2.0);
    if (expected <= 0.0)
        return judge(slide.distance, 1e-3, 1e-2, fmt::format("sticks\n{:.2g} mm", slide.distance * 1e3));
    const double off = std::abs(slide.acceleration / expected - 1.0);
    return judge(off, 0.01, 0.05, fmt::format("slides\n{:.2g} %", off * 100.0));
}

Judged judgeCrowd(double side, size_t row, bool) {
    const Container container = fillContainer(presets()[row].settings, int(side), 6.0);
    const std::string text =
        fmt::format("{:.2g} mm\n{:.2g} mm", container.meanOverlap * 1e3, container.worstOverlap * 1e3);
    return container.allInside ? judge(std::max(container.meanOverlap * 10.0, container.worstOverlap), 0.01, 0.05, text)
                               : Judged{Outcome::Failed, "gets out"};
}

Judged judgeOverlap(double share, size_t row, bool) {
    const Recovery recovery = partOverlapping(presets()[row].settings, share);
    return judge(std::max(recovery.fastest / 4.0, recovery.overlap / 0.002), 1.0, 3.0,
                 fmt::format("{:.1f} m/s\n{:.1f} mm", recovery.fastest, recovery.overlap * 1e3));
}

/// Free rotation, and towers.
std::vector<Map> spinAndStackMaps() {
    const std::vector<double> voxelSizes{0.001, 0.002, 0.005, 0.01, 0.025, 0.1};
    return {
        {"T13-spin",
         "free rotation of rods",
         "energy conserved within 0.1 %, momentum within 1e-5; degraded: 10 %, 0.1 %",
         "spin, rad/s",
         "rad/s",
         {1, 10, 30, 100, 300},
         {1000},
         "rod",
         {"1:1", "1:4", "1:16", "1:64"},
         judgeSpin},
        {"T13-stack",
         "towers of half-metre cubes, without sleep",
         "at most 2 cm lower after 10 s (30 s with --full); degraded: it stands",
         "cubes",
         "cubes",
         {5, 10, 15, 20, 30, 40},
         {60, 80},
         "preset",
         presetNames(),
         judgeStack},
        {"T13-small-stack",
         "stacks of cubes of 4x4x4 voxels, by voxel size (preset balanced)",
         "after 10 s each cube is within a voxel of its place; degraded: two voxels",
         "cubes",
         "cubes",
         {2, 3, 4, 5, 6, 7, 8, 9, 10, 15, 20, 25, 30, 35},
         {},
         "voxels of, m",
         namesOf(voxelSizes),
         [voxelSizes](double cubes, size_t row, bool) { return judgeSmallStack(cubes, voxelSizes[row]); }},
    };
}

/// Heavy bodies on light ones.
std::vector<Map> massMaps() {
    const std::vector<double> ratios{3, 10, 30, 100, 300, 1000};
    return {
        {"T13-mass",
         "heavy cube on a light one",
         "sinks by less than 1 cm in 10 s; degraded: half a voxel",
         "times as heavy",
         "times",
         {10, 30, 100, 300, 1000, 3000, 10000},
         {100000},
         "preset",
         presetNames(),
         [](double ratio, size_t row, bool) { return judgeRatio(presets()[row].settings, ratio); }},
        {"T13-substeps",
         "heavy cube on a light one, by substeps",
         "sinks by less than 1 cm in 10 s; degraded: half a voxel",
         "substeps",
         "substeps",
         {16, 8, 4, 2, 1},
         {},
         "times as heavy",
         namesOf(ratios),
         [ratios](double substeps, size_t row, bool) {
             PhysicsSettings settings;
             settings.substeps = int(substeps);
             return judgeRatio(settings, ratios[row]);
         }},
    };
}

/// Bodies at rest.
std::vector<Map> restMaps() {
    const std::vector<double> sizes{0.01, 0.1, 1.0};
    const std::vector<glm::ivec3> shapes{{1, 1, 1}, {3, 3, 3}, {20, 1, 20}, {10, 1, 1}};
    return {
        {"T13-size",
         "bodies at rest, by size",
         "slower than 1 mm/s, in proportion to the voxel size above 10 cm; degraded: ten times that",
         "voxel size, m",
         "m",
         {0.001, 0.003, 0.01, 0.1, 1, 10},
         {30},
         "voxels",
         {"1", "3x3x3", "20x1x20", "10x1x1"},
         [shapes](double size, size_t row, bool) { return judgeRest(size, 9.81, shapes[row]); }},
        {"T13-gravity",
         "cubes of 3x3x3 voxels at rest, by gravity",
         "slower than 1 mm/s, in proportion to the voxel size above 10 cm; degraded: ten times that",
         "gravity, m/s2",
         "m/s2",
         {0.1, 1, 9.81, 30, 100, 300},
         {1000},
         "voxel size, m",
         namesOf(sizes),
         [sizes](double gravity, size_t row, bool) { return judgeRest(sizes[row], gravity, glm::ivec3(3)); }},
    };
}

/// Fast, distant and sliding bodies.
std::vector<Map> motionMaps() {
    const std::vector<double> frictions{0.1, 0.3, 0.6, 1.0};
    return {
        {"T13-tunnel",
         "shots of one to four voxels at a wall",
         "none goes through; degraded: 2 %",
         "speed, m/s",
         "m/s",
         {10, 30, 100, 300, 1000},
         {3000, 10000},
         "wall, voxels",
         {"1", "2", "4"},
         judgeShots},
        {"T13-distance",
         "six pieces that fall, slide and tumble, far from the origin",
         "end within 1 mm of where they end at the origin, at all of eight places at the distance; degraded: 1 cm",
         "distance, km",
         "km",
         {1, 10, 100, 1000, 10000},
         {100000},
         "preset",
         presetNames(),
         judgeDistance},
        {"T13-incline",
         "a block on a slope",
         "below the angle of friction it stays within 1 mm, above it its acceleration is within 1 % of Coulomb's law; "
         "degraded: 1 cm, 5 %",
         "slope, degrees",
         "degrees",
         {3, 10, 20, 30, 40, 50},
         {60, 75},
         "friction",
         namesOf(frictions),
         [frictions](double degrees, size_t row, bool) { return judgeIncline(degrees, frictions[row]); }},
    };
}

/// Crowded and overlapping bodies.
std::vector<Map> overlapMaps() {
    return {
        {"T13-crowd",
         "cubes of half a metre in a box of walls",
         "overlap by at most 1 mm on average and 1 cm in any pair, none gets out; degraded: 5 times that",
         "cubes along a side",
         "cubes",
         {2, 3, 4},
         {6, 8, 10},
         "preset",
         presetNames(),
         judgeCrowd},
        {"T13-overlap",
         "two cubes that overlap at the start",
         "separate at less than 4 m/s and overlap by less than 2 mm after 3 s; degraded: three times that",
         "share of one cube in the other",
         "",
         {0.1, 0.3, 0.5, 0.7, 0.9},
         {0.99},
         "preset",
         presetNames(),
         judgeOverlap},
    };
}

std::vector<Map> maps() {
    std::vector<Map> all;
    for (const auto& group : {spinAndStackMaps(), massMaps(), restMaps(), motionMaps(), overlapMaps(), impactMaps(),
                              loadMaps(), rollingMaps(), sleepAndSeamMaps()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

}  // namespace

std::vector<std::pair<std::string, std::function<Table(const Options&)>>> physicsMaps() {
    std::vector<std::pair<std::string, std::function<Table(const Options&)>>> all;
    for (const Map& map : maps())
        all.emplace_back(map.name, [map](const Options& options) { return drawMap(options, map); });
    return all;
}

}  // namespace rubble::tradeoff
