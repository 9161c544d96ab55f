#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/cpu_time.h"

namespace rubble::tradeoff {

/// Options of the command line.
struct Options {
    std::string out = "out/tradeoff";
    uint64_t seed = 1;
    int repeats = 5;
    bool full = false;  ///< every combination; else a selection that takes under a minute
};

/// Median and range of repeated measurements.
struct Measured {
    double median = 0.0, low = 0.0, high = 0.0;
    std::string text() const;  ///< "1.20 (1.15 to 1.31)"
};
/// Median and range of values.
Measured summary(const std::vector<double>& values);
/// Median and range of `repeats` results of once().
Measured measure(int repeats, const std::function<double()>& once);
/// The value below which a share (0 to 1) of the values lies; 0 without values.
double quantile(std::vector<double> values, double share);

/// A row of a map: for which values it is stable.
struct StableRange {
    std::string row;
    std::string holds;       ///< "stable up to 20 cubes, fails at 40 cubes"
    std::string fails = {};  ///< "40 cubes", the first value that fails; empty: none
};

/// A table of the report: settings, their costs and their errors.
struct Table {
    std::string name;   ///< name of the table and of its files
    std::string title;  ///< a sentence
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
    std::string note = {};                   ///< explains the columns
    std::string conclusion = {};             ///< the result in a sentence, with its figures
    std::vector<StableRange> envelope = {};  ///< of maps
    bool failed = false;                     ///< a promise does not hold; the conclusion says which
    std::string stamp = {};                  ///< see stamp(), when it was measured
    /// Adds a row with as many cells as there are columns.
    void add(std::vector<std::string> row) { rows.push_back(std::move(row)); }
};

/// What the figures depend on: machine, processors, load, commit, seed and repeats.
std::string stamp(const Options& options);
/// Writes NAME.csv with the stamp in its first line; false if it cannot be written.
bool writeCsv(const Options& options, const Table& table);
/// The table as Markdown, with note and conclusion.
std::string markdown(const Table& table);

/// Points of a plot, connected by lines unless they are a cloud; marks are large points with their name beside them.
struct Series {
    std::string name;
    std::vector<std::pair<double, double>> points;
    bool isCloud = false, isMark = false;
};
/// The Pareto front of points: those for which no other point is smaller in both x and y.
Series paretoFront(const std::string& name, std::vector<std::pair<double, double>> all);
/// Writes NAME.svg with series of points; false if it cannot be written.
bool writePlot(const Options& options, const std::string& name, const std::string& title, const std::string& xLabel,
               const std::string& yLabel, const std::vector<Series>& series);

/// A bar with its spread; bars of one group stand side by side.
struct Bar {
    std::string group, name;
    Measured value;
};
/// Writes NAME.svg with groups of bars; false if it cannot be written.
bool writeBars(const Options& options, const std::string& name, const std::string& title, const std::string& yLabel,
               const std::vector<Bar>& bars);

/// Outcome of a point of a map. Refused: the input was rejected without effect.
enum class Outcome { Stable, Degraded, Failed, Refused };
/// The outcome's name in tables, in lower case.
const char* nameOf(Outcome outcome);

struct MapCell {
    std::string x, y;
    Outcome outcome;
    std::string text;  ///< its figures, in one or two lines
};
using Meanings = std::array<const char*, 4>;  ///< legend of the outcomes; null: not in this map
/// Writes NAME.svg with a map's coloured cells; false if it cannot be written.
bool writeMap(const Options& options, const std::string& name, const std::string& title, const std::string& xLabel,
              const std::string& yLabel, const std::vector<MapCell>& cells, const Meanings& meanings);

}  // namespace rubble::tradeoff
