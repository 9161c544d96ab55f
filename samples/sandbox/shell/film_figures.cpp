#include "samples/sandbox/shell/film_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sandbox {
namespace {

constexpr size_t kWorst = 5;     ///< steps that are named
constexpr double kBarMs = 25.0;  ///< milliseconds of a full bar
constexpr int kBarWidth = 25;

struct Stage {
    const char* name;
    double rubble_step_stats::*milliseconds;
};
constexpr Stage kStages[] = {
    {"edits", &rubble_step_stats::edits_ms},   {"physics", &rubble_step_stats::physics_ms},
    {"poses", &rubble_step_stats::poses_ms},   {"impacts", &rubble_step_stats::impacts_ms},
    {"shadow", &rubble_step_stats::shadow_ms}, {"publish", &rubble_step_stats::publish_ms},
};

double total(const rubble_step_stats& stats) {
    double sum = 0.0;
    for (const Stage& stage : kStages) sum += stats.*stage.milliseconds;
    return sum;
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, size_t(share * double(values.size())))];
}

/// '#' up to the first of two values, '-' on to the second.
std::string bar(double value, double further, double full) {
    const auto cells = [&](double of) { return std::clamp(int(std::lround(of / full * kBarWidth)), 0, kBarWidth); };
    const int solid = cells(value), thin = std::max(cells(further), solid);
    return fmt::format("[{}{}{}]", std::string(size_t(solid), '#'), std::string(size_t(thin - solid), '-'),
                       std::string(size_t(kBarWidth - thin), ' '));
}

std::string row(const std::string& name, const std::vector<double>& values, double full, int digits) {
    const double median = quantile(values, 0.5), high = quantile(values, 0.99);
    return fmt::format("{:<20}{:>10.{}f}{:>10.{}f}{:>10.{}f}  {}\n", name, median, digits, high, digits,
                       quantile(values, 1.0), digits, bar(median, high, full > 0.0 ? full : std::max(high, 1e-9)));
}

}  // namespace

void FilmFigures::addStep(const rubble_step_stats& stats, uint64_t allocations) {
    m_steps.push_back({m_shots.empty() ? 0 : m_shots.size() - 1, stats, allocations});
}

std::string FilmFigures::worstSteps() const {
    std::vector<const Step*> order;
    for (const Step& step : m_steps) order.push_back(&step);
    const size_t count = std::min(kWorst, order.size());
    std::partial_sort(order.begin(), order.begin() + ptrdiff_t(count), order.end(),
                      [](const Step* a, const Step* b) { return total(a->stats) > total(b->stats); });
    std::string out = "longest steps\n";
    for (size_t i = 0; i < count; ++i) {
        const rubble_step_stats& stats = order[i]->stats;
        std::vector<Stage> stages(std::begin(kStages), std::end(kStages));
        std::sort(stages.begin(), stages.end(),
                  [&](const Stage& a, const Stage& b) { return stats.*a.milliseconds > stats.*b.milliseconds; });
        out += fmt::format("  {:>6.1f} ms  step {} of \"{}\": {} {:.1f}, {} {:.1f}; {} of {} bodies awake\n",
                           total(stats), stats.step, m_shots.empty() ? "" : m_shots[order[i]->shot], stages[0].name,
                           stats.*stages[0].milliseconds, stages[1].name, stats.*stages[1].milliseconds,
                           stats.bodies_awake, stats.bodies);
    }
    return out;
}

std::string FilmFigures::table() const {
    const auto collect = [&](auto&& valueOf) {
        std::vector<double> values;
        for (const Step& step : m_steps) values.push_back(valueOf(step));
        return values;
    };
    std::string out = fmt::format("{} steps, {} frames\n{:<20}{:>10}{:>10}{:>10}  # median  - p99\n", m_steps.size(),
                                  m_frames.size(), "", "median", "p99", "longest");
    out += row("step, ms", collect([](const Step& step) { return total(step.stats); }), kBarMs, 2);
    for (const Stage& stage : kStages)
        out += row(fmt::format("  {}", stage.name),
                   collect([&](const Step& step) { return step.stats.*stage.milliseconds; }), kBarMs, 2);
    out += row("frame drawn, ms", m_frames, 0.0, 0);
    out += row("allocations a step", collect([](const Step& step) { return double(step.allocations); }), 0.0, 0);
    out += row("shadow age, steps", collect([](const Step& step) { return double(step.stats.shadow_lag); }), 0.0, 0);
    out += row("bodies awake", collect([](const Step& step) { return double(step.stats.bodies_awake); }), 0.0, 0);
    out += row("contact points", collect([](const Step& step) { return double(step.stats.contacts); }), 0.0, 0);
    return out + worstSteps();
}

}  // namespace sandbox
