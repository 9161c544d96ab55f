#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rubble::tradeoff {

/// What the command line asked for.
struct Options {
    std::string out = "out/tradeoff";
    uint64_t seed = 1;
    int repeats = 5;
    bool full = false;  ///< every combination; else a cut through them that takes under a minute
};

/// Repeated measurement of one thing.
struct Measured {
    double median = 0.0, low = 0.0, high = 0.0;
    std::string text() const;  ///< "1.20 (1.15 to 1.31)"
};
Measured summary(const std::vector<double>& values);
Measured measure(int repeats, const std::function<double()>& once);
double quantile(std::vector<double> values, double share);
/// Milliseconds of this thread's processor time that something takes: what else the machine does is left out.
double cpuMs(const std::function<void()>& f);

/// A table of one report: what is turned, what it costs, what it gets wrong.
struct Table {
    std::string name;   ///< of its files
    std::string title;  ///< a sentence
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
    std::string note = {};                                           ///< what the words in it mean
    std::string conclusion = {};                                     ///< what it comes down to, from its figures
    std::vector<std::pair<std::string, std::string>> envelope = {};  ///< of extreme maps: what, and how far it holds
    bool failed = false;  ///< something that was promised is not so; the bottom line says what
    void add(std::vector<std::string> row) { rows.push_back(std::move(row)); }
};

/// Machine, processors, commit, date-free: what a figure depends on.
std::string stamp(const Options& options);
/// NAME.csv with the stamp in its first line; false if it cannot be written.
bool writeCsv(const Options& options, const Table& table);
std::string markdown(const Table& table);

/// Points, joined by lines unless they are a cloud; marks are large and named beside them. Drawn as SVG text.
struct Series {
    std::string name;
    std::vector<std::pair<double, double>> points;
    bool isCloud = false, isMark = false;
};
/// The points of `all` that no other is better than in both: the least y for each x, from the least x on.
Series paretoFront(const std::string& name, std::vector<std::pair<double, double>> all);
bool writePlot(const Options& options, const std::string& name, const std::string& title, const std::string& xLabel,
               const std::string& yLabel, const std::vector<Series>& series);

/// A bar with its spread; bars of one group stand side by side.
struct Bar {
    std::string group, name;
    Measured value;
};
bool writeBars(const Options& options, const std::string& name, const std::string& title, const std::string& yLabel,
               const std::vector<Bar>& bars);

/// How a point of an extreme map came out.
enum class Outcome { Stable, Degraded, Failed, Refused };
const char* nameOf(Outcome outcome);
struct MapCell {
    std::string x, y;
    Outcome outcome;
    std::string text;  ///< the figure behind it, in one or two lines
};
using Meanings = std::array<const char*, 4>;  ///< of the outcomes, in words for the legend; null: it does not occur
bool writeMap(const Options& options, const std::string& name, const std::string& title, const std::string& xLabel,
              const std::string& yLabel, const std::vector<MapCell>& cells, const Meanings& meanings);

}  // namespace rubble::tradeoff
