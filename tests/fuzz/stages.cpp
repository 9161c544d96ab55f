#include "tests/fuzz/stages.h"

#include <fmt/format.h>

#include <map>
#include <string_view>

namespace rubble {
namespace {

std::map<std::string_view, unsigned long long>& counts() {
    static std::map<std::string_view, unsigned long long> all;
    return all;
}

}  // namespace

void reached(const char* stage) {
    ++counts()[stage];
}

std::string stageReport(unsigned long long inputs) {
    std::string out;
    for (const auto& [stage, count] : counts())
        out += fmt::format("  {}: {}, {:.2f} an input\n", stage, count, double(count) / double(inputs));
    return out;
}

}  // namespace rubble
