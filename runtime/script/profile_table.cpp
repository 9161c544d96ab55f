#include "runtime/script/profile_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

constexpr const char* kHead = "script                        calls        ms  allocations     memory";

std::string lineOf(const std::string& name, double calls, double seconds, double allocations) {
    return fmt::format("{:<26.26} {:>8.1f} {:>9.3f} {:>12.1f}", name, calls, 1e3 * seconds, allocations);
}

/// The names of callbacks, then those of functions.
std::vector<std::string> names(const Script& script) {
    std::vector<std::string> all;
    for (size_t i = 0; i < kCallbacks; ++i) all.emplace_back(nameOf(Callback(i)));
    for (const Subject& subject : vocabulary())
        for (const ScriptFunction& function : subject.functions) all.push_back(function.name());
    for (const ScriptFunction& function : script.context().shared.hostFunctions) all.push_back(function.name());
    return all;
}

}  // namespace

ProfileTable::Costs ProfileTable::costsOf(const Script& script) {
    Costs costs;
    for (size_t i = 0; i < kCallbacks; ++i) {
        const CallbackProfile& profile = script.profile(Callback(i));
        costs.push_back({double(profile.calls), profile.seconds, double(profile.allocations)});
    }
    const ScriptContext& context = script.context();
    for (size_t i = 0; i < context.costs.size(); ++i)
        costs.push_back({double(context.calls[i]), context.costs[i].seconds, double(context.costs[i].allocations)});
    return costs;
}

void ProfileTable::update(const std::list<Script>& scripts) {
    if (m_lines.empty()) {
        m_lines = {kHead};
        for (const Script& script : scripts) m_written[&script] = costsOf(script);
    } else if (++m_frames == kFrames) {
        write(scripts);
        m_frames = 0;
    }
}

void ProfileTable::write(const std::list<Script>& scripts) {
    std::map<const Script*, Costs> now;
    std::vector<std::pair<double, const Script*>> order;  // negative costs: the highest is first
    std::map<const Script*, Costs> recent;
    for (const Script& script : scripts) {
        now[&script] = costsOf(script);
        Costs& costs = recent[&script] = now[&script];
        const Costs& before = m_written[&script];
        double seconds = 0.0;
        for (size_t i = 0; i < costs.size(); ++i) {
            // Another script, or one that has begun again, counts from zero.
            const Cost old = i < before.size() && before[i].calls <= costs[i].calls ? before[i] : Cost{};
            costs[i] = {(costs[i].calls - old.calls) / kFrames, (costs[i].seconds - old.seconds) / kFrames,
                        (costs[i].allocations - old.allocations) / kFrames};
            if (i < kCallbacks) seconds += costs[i].seconds;
        }
        order.emplace_back(-seconds, &script);
    }
    std::stable_sort(order.begin(), order.end(), [](auto& a, auto& b) { return a.first < b.first; });
    m_lines = {kHead};
    for (const auto& [seconds, script] : order) writeScript(*script, recent[script]);
    if (m_lines.size() > kMaxRows + 1) {
        const size_t more = m_lines.size() - kMaxRows;
        m_lines.resize(kMaxRows);
        m_lines.push_back(fmt::format("... {} more", more));
    }
    m_written = std::move(now);
}

void ProfileTable::writeScript(const Script& script, const Costs& costs) {
    Cost sum;
    std::vector<size_t> rows;
    for (size_t i = 0; i < costs.size(); ++i) {
        if (i < kCallbacks)
            sum = {sum.calls + costs[i].calls, sum.seconds + costs[i].seconds, sum.allocations + costs[i].allocations};
        if (costs[i].calls > 0.0) rows.push_back(i);
    }
    m_lines.push_back(lineOf(script.name(), sum.calls, sum.seconds, sum.allocations) +
                      fmt::format(" {:>6.0f} KiB", double(script.sandbox().memoryUsed()) / 1024.0));
    std::stable_sort(rows.begin(), rows.end(), [&](size_t a, size_t b) { return costs[a].seconds > costs[b].seconds; });
    const std::vector<std::string> all = names(script);
    for (const size_t row : rows)
        m_lines.push_back(lineOf("  " + all[row], costs[row].calls, costs[row].seconds, costs[row].allocations));
}

}  // namespace rubble::script
