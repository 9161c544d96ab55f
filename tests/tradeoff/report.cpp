#include "tests/tradeoff/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <thread>

#include "generated/paths.h"

namespace rubble::tradeoff {
namespace {

std::string outputOf(const std::string& command) {
    std::string out;
    if (FILE* pipe = popen(command.c_str(), "r")) {
        char buffer[256];
        while (std::fgets(buffer, sizeof buffer, pipe)) out += buffer;
        pclose(pipe);
    }
    while (!out.empty() && (out.back() == '\n' || out.back() == ' ')) out.pop_back();
    return out;
}

std::string joined(const std::vector<std::string>& cells, const char* separator) {
    std::string out;
    for (size_t i = 0; i < cells.size(); ++i) out += (i ? separator : "") + cells[i];
    return out;
}

}  // namespace

std::string Measured::text() const {
    return fmt::format("{:.3g} ({:.3g} to {:.3g})", median, low, high);
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, size_t(share * double(values.size())))];
}

Measured summary(const std::vector<double>& values) {
    return {quantile(values, 0.5), quantile(values, 0.0), quantile(values, 1.0)};
}

Measured measure(int repeats, const std::function<double()>& once) {
    std::vector<double> values;
    for (int i = 0; i < repeats; ++i) values.push_back(once());
    return summary(values);
}

std::string stamp(const Options& options) {
    const std::string cpu = outputOf("sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -1");
    const std::string commit = outputOf("git -C '" RUBBLE_SOURCE_DIR "' describe --always --dirty 2>/dev/null");
    const std::string load = outputOf("cut -d' ' -f1 /proc/loadavg");
    return fmt::format("machine: {}, {} processors, load {}; commit: {}; seed: {}; {} of {} runs",
                       cpu.empty() ? "unknown" : cpu, std::thread::hardware_concurrency(), load,
                       commit.empty() ? "unknown" : commit, options.seed, "medians (spread)", options.repeats);
}

bool writeCsv(const Options& options, const Table& table) {
    std::ofstream file(options.out + "/" + table.name + ".csv");
    file << "# " << stamp(options) << "\n" << joined(table.columns, ",") << "\n";
    for (const auto& row : table.rows) file << joined(row, ",") << "\n";
    if (!table.conclusion.empty()) file << "# " << (table.failed ? "FAILED: " : "") << table.conclusion << "\n";
    return bool(file.flush());
}

std::string markdown(const Table& table) {
    std::string out = fmt::format("## {}: {}\n\n| {} |\n|", table.name, table.title, joined(table.columns, " | "));
    for (size_t i = 0; i < table.columns.size(); ++i) out += " --- |";
    out += "\n";
    for (const auto& row : table.rows) out += "| " + joined(row, " | ") + " |\n";
    if (!table.note.empty()) out += "\n" + table.note + "\n";
    if (!table.conclusion.empty()) out += fmt::format("\n{}**{}**\n", table.failed ? "FAILED: " : "", table.conclusion);
    return out + "\n";
}

}  // namespace rubble::tradeoff
