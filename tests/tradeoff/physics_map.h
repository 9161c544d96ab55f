#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tests/tradeoff/report.h"

/// Maps of physics: one parameter increases until physics fails, for each value of another.
namespace rubble::tradeoff {

struct Judged {
    Outcome outcome;
    std::string text;  ///< its figures, in one or two lines
};
/// Stable up to one limit, degraded up to the next, else failed; NaN fails.
Judged judge(double value, double stable, double degraded, const std::string& text);

/// A map of two parameters.
struct Map {
    const char *name, *title, *criterion;
    const char *xLabel, *xUnit;
    std::vector<double> pushed, pushedFull;  ///< values of x from easy to hard; further ones for --full
    const char* yLabel;
    std::vector<std::string> rows;
    std::function<Judged(double x, size_t row, bool full)> evaluate;
};
/// Evaluates a map and draws it.
Table drawMap(const Options& options, const Map& map);

/// The names of presets().
std::vector<std::string> presetNames();
/// Values as names of rows.
std::vector<std::string> namesOf(const std::vector<double>& values, const char* unit = "");

/// Impacts: shafts, ledges, bounces, cradles, blades, spin on the floor.
std::vector<Map> impactMaps();
/// Water, ropes and who walks on planks.
std::vector<Map> loadMaps();
/// Wheels and cars.
std::vector<Map> rollingMaps();
/// Sleep, seams, and ropes over what is thin or near.
std::vector<Map> sleepAndSeamMaps();

}  // namespace rubble::tradeoff
