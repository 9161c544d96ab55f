#include "tests/tradeoff/valgrind_counts.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

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

/// The number at the beginning of a text, written as "1,234,567"; 0 if there is none.
double countIn(const std::string& text) {
    std::string digits = text.substr(0, text.find_first_not_of("0123456789, "));
    digits.erase(std::remove_if(digits.begin(), digits.end(), [](char c) { return c < '0' || c > '9'; }), digits.end());
    return digits.empty() ? 0.0 : std::stod(digits);
}

std::filesystem::path fileOf(const char* tool) {
    return std::filesystem::temp_directory_path() / fmt::format("rubble_{}_{}", tool, getpid());
}

/// The first function of ours in a text: "rubble::World::hash" in "... rubble::World::hash() ..."; else "".
std::string functionIn(const std::string& text) {
    const size_t name = text.find("rubble::"), end = text.find('(', name);
    return name == std::string::npos || end == std::string::npos ? "" : text.substr(name, end - name);
}

}  // namespace

double instructionsOf(const std::string& scene) {
    double count = 0.0;
    const std::string command = fmt::format(
        "valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null '{}' physics --feature-scene '{}' "
        "2>&1",
        self(), scene);
    forEachLine(command, [&](const std::string& line) {
        const size_t at = line.find("refs:");
        if (at != std::string::npos) count = countIn(line.substr(at + 5));
    });
    return count;
}

std::map<std::string, double> instructionsByFunction(const std::string& scene) {
    const std::string out = fileOf("callgrind").string();
    std::map<std::string, double> counts;
    const std::string count =
        fmt::format("valgrind --tool=callgrind --callgrind-out-file='{}' '{}' physics --feature-scene '{}' 2>&1", out,
                    self(), scene);
    forEachLine(count, [](const std::string&) {});
    // A line looks like "1,234 ( 0.01%)  ???:rubble::World::hash() [/path/of/the/program]".
    forEachLine(fmt::format("callgrind_annotate --inclusive=yes --threshold=100 '{}' 2>/dev/null", out),
                [&](const std::string& line) {
                    if (const std::string function = functionIn(line); !function.empty())
                        counts.emplace(function, countIn(line));
                });
    std::filesystem::remove(out);
    return counts;
}

std::map<std::string, double> bytesByFunction(const std::string& scene) {
    const std::filesystem::path out = fileOf("dhat");
    const std::string count =
        fmt::format("valgrind --tool=dhat --num-callers=60 --dhat-out-file='{}' '{}' physics --feature-scene '{}' 2>&1",
                    out.string(), self(), scene);
    forEachLine(count, [](const std::string&) {});
    std::map<std::string, double> counts;
    const nlohmann::json all = nlohmann::json::parse(std::ifstream(out), nullptr, false);
    std::filesystem::remove(out);
    if (!all.is_object()) return counts;
    const std::vector<std::string> frames = all.value("ftbl", std::vector<std::string>());
    for (const nlohmann::json& place : all.value("pps", nlohmann::json::array())) {
        std::set<std::string> functions;
        for (const size_t frame : place.value("fs", std::vector<size_t>()))
            if (frame < frames.size()) functions.insert(functionIn(frames[frame]));
        for (const std::string& function : functions) counts[function] += place.value("tb", 0.0);
    }
    return counts;
}

}  // namespace rubble::tradeoff
