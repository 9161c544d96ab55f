#include "samples/stress/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "runtime/script/binding/script_context.h"
#include "samples/stress/results.h"

namespace stress {
namespace {

constexpr size_t kPlotPoints = 600;

/// One curve: the largest value of each stretch of steps, so that no peak is lost.
template <class Value>
nlohmann::json plotOf(const std::vector<StepFigures>& steps, Value&& value) {
    nlohmann::json points = nlohmann::json::array();
    const size_t stretch = std::max<size_t>(1, (steps.size() + kPlotPoints - 1) / kPlotPoints);
    for (size_t i = 0; i < steps.size(); i += stretch) {
        double largest = double(value(steps[i]));
        for (size_t k = i; k < std::min(steps.size(), i + stretch); ++k)
            largest = std::max(largest, double(value(steps[k])));
        points.push_back(std::round(largest * 1000.0) / 1000.0);
    }
    return points;
}

/// Median, 95th and 99th percentile and the largest, in ms.
template <class Value>
nlohmann::json percentilesOf(const std::vector<StepFigures>& steps, Value&& value) {
    std::vector<double> sorted;
    for (const StepFigures& step : steps) sorted.push_back(double(value(step)));
    if (sorted.empty()) return {0.0, 0.0, 0.0, 0.0};
    std::sort(sorted.begin(), sorted.end());
    const auto at = [&](size_t percent) { return sorted[std::min(sorted.size() - 1, sorted.size() * percent / 100)]; };
    return {at(50), at(95), at(99), sorted.back()};
}

/// The processor as the system calls it, and how many there are.
std::string machineName() {
    std::string name = "unknown processor";
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (const size_t colon = line.find(": "); line.starts_with("model name") && colon != line.npos) {
            name = line.substr(colon + 2);
            break;
        }
    return fmt::format("{}, {} processors", name, std::thread::hardware_concurrency());
}

double stepMs(const StepFigures& step) {
    return step.editsMs + step.physicsMs + step.posesMs + step.impactsMs + step.shadowMs;
}

}  // namespace

std::string writeFigures(const std::string& build, const std::string& command, const RunSettings& settings,
                         const RunResult& result, double seconds, const Minimised& found) {
    nlohmann::json file;
    const std::vector<StepFigures>& steps = result.steps;
    file["scenario"] = settings.name;
    file["seed"] = settings.seed;
    file["build"] = build;
    file["machine"] = machineName();
    file["file"] = settings.file;
    file["command"] = command;
    file["minutes"] = settings.steps / 3600.0;
    file["check_every"] = settings.checkInterval / 60.0;
    file["threads"] = settings.hasThreads;
    file["steps"] = steps.size();
    file["seconds"] = seconds;
    file["processor_seconds"] = result.seconds;
    file["heap_left"] = result.heapLeft;
    file["hash"] = fmt::format("{:016x}", result.hash);
    file["replayed_steps"] = result.replayed;
    file["loads"] = result.loads;
    if (result.isInterrupted) file["interrupted"] = true;
    if (result.failure)
        file["failure"] = {{"check", result.failure->check},
                           {"message", result.failure->message},
                           {"step", result.failure->step},
                           {"script", found.script},
                           {"no_script", found.why}};
    nlohmann::json& stages = file["ms_p50_p95_p99_max"];
    stages["edits"] = percentilesOf(steps, [](const StepFigures& step) { return step.editsMs; });
    stages["physics"] = percentilesOf(steps, [](const StepFigures& step) { return step.physicsMs; });
    stages["poses"] = percentilesOf(steps, [](const StepFigures& step) { return step.posesMs; });
    stages["impacts"] = percentilesOf(steps, [](const StepFigures& step) { return step.impactsMs; });
    stages["shadow"] = percentilesOf(steps, [](const StepFigures& step) { return step.shadowMs; });
    stages["step"] = percentilesOf(steps, stepMs);
    nlohmann::json& plots = file["plots"];
    plots["step, ms"] = plotOf(steps, stepMs);
    plots["bodies"] = plotOf(steps, [](const StepFigures& step) { return step.bodies; });
    plots["awake bodies"] = plotOf(steps, [](const StepFigures& step) { return step.awake; });
    plots["contacts"] = plotOf(steps, [](const StepFigures& step) { return step.contacts; });
    plots["standing voxels"] = plotOf(steps, [](const StepFigures& step) { return step.standing; });
    plots["voxels in pieces"] = plotOf(steps, [](const StepFigures& step) { return step.pieces; });
    plots["removed voxels"] = plotOf(steps, [](const StepFigures& step) { return step.removed; });
    plots["shadow lag, steps"] = plotOf(steps, [](const StepFigures& step) { return step.shadowLag; });
    plots["kinetic energy, kJ"] = plotOf(steps, [](const StepFigures& step) { return step.energy / 1e3; });
    plots["heap, MiB"] = plotOf(steps, [](const StepFigures& step) { return double(step.heap) / (1 << 20); });
    const std::string begun = resultPath(settings, ".json.part"), path = resultPath(settings, ".json");
    std::ofstream out(begun);
    out << file.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
    std::error_code error;
    if (out.flush()) std::filesystem::rename(begun, path, error);
    return out && !error ? "" : "cannot write " + path;
}

}  // namespace stress
