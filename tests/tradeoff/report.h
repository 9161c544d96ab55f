#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rubble::tradeoff {

/// What the command line asked for.
struct Options {
    std::string out = "out/tradeoff";
    uint64_t seed = 1;
    bool full = false;  ///< every combination; else a cut through them that takes under a minute
    int repeats() const { return full ? 5 : 3; }
};

/// Repeated measurement of one thing.
struct Measured {
    double median = 0.0, low = 0.0, high = 0.0;
    std::string text() const;  ///< "1.20 (1.15 to 1.31)"
};
Measured measure(int repeats, const std::function<double()>& once);
double quantile(std::vector<double> values, double share);

/// A table of one report: what is turned, what it costs, what it gets wrong.
struct Table {
    std::string name;   ///< of its files
    std::string title;  ///< a sentence
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
    void add(std::vector<std::string> row) { rows.push_back(std::move(row)); }
};

/// Machine, processors, commit, date-free: what a figure depends on.
std::string stamp(const Options& options);
/// NAME.csv with the stamp in its first line; false if it cannot be written.
bool writeCsv(const Options& options, const Table& table);
std::string markdown(const Table& table);

/// Lines through points, drawn as SVG text.
struct Series {
    std::string name;
    std::vector<std::pair<double, double>> points;
};
bool writePlot(const Options& options, const std::string& name, const std::string& title, const std::string& xLabel, const std::string& yLabel,
               const std::vector<Series>& series);

/// How a point of an extreme map came out.
enum class Outcome { Stable, Degraded, Refused };
const char* nameOf(Outcome outcome);
struct MapCell {
    std::string x, y;
    Outcome outcome;
    std::string text;  ///< the figure behind it
};
bool writeMap(const Options& options, const std::string& name, const std::string& title, const std::string& xLabel, const std::string& yLabel,
              const std::vector<MapCell>& cells);

}  // namespace rubble::tradeoff
