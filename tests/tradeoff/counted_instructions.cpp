#include "tests/tradeoff/counted_instructions.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>

namespace rubble::tradeoff {
namespace {

void forEachLine(const std::string& command, const std::function<void(std::string)>& see) {
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return;
    char line[4096];
    while (std::fgets(line, sizeof line, pipe)) see(line);
    pclose(pipe);
}

std::string self() {
    char path[4096] = {};
    return readlink("/proc/self/exe", path, sizeof path - 1) < 0 ? "" : path;
}

/// "1,234,567" at the beginning of a text; 0 if there is none.
double countIn(const std::string& text) {
    std::string digits = text.substr(0, text.find_first_not_of("0123456789, "));
    digits.erase(std::remove_if(digits.begin(), digits.end(), [](char c) { return c < '0' || c > '9'; }), digits.end());
    return digits.empty() ? 0.0 : std::stod(digits);
}

}  // namespace

double instructionsOf(const std::string& scene) {
    double count = 0.0;
    const std::string command = fmt::format(
        "valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null '{}' physics --feature-scene '{}' 2>&1", self(), scene);
    forEachLine(command, [&](const std::string& line) {
        const size_t at = line.find("refs:");
        if (at != std::string::npos) count = countIn(line.substr(at + 5));
    });
    return count;
}

std::map<std::string, double> instructionsByFunction(const std::string& scene) {
    const std::string out = (std::filesystem::temp_directory_path() / fmt::format("rubble_callgrind_{}", getpid())).string();
    std::map<std::string, double> counts;
    const std::string count =
        fmt::format("valgrind --tool=callgrind --callgrind-out-file='{}' '{}' physics --feature-scene '{}' 2>&1", out, self(), scene);
    forEachLine(count, [](const std::string&) {});
    forEachLine(fmt::format("callgrind_annotate --inclusive=yes --threshold=100 '{}' 2>/dev/null", out), [&](std::string line) {
        // "1,234 ( 0.01%)  ???:rubble::EditStep::burn() [/path/of/the/program]"
        const size_t name = line.find("rubble::"), end = line.find(')', name);
        if (name == std::string::npos || end == std::string::npos) return;
        counts.emplace(line.substr(name, line.find('(', name) - name), countIn(line));
    });
    std::filesystem::remove(out);
    return counts;
}

}  // namespace rubble::tradeoff
