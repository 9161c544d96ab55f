#include "render/shader_library/fullscreen_choice.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace rubble {

FullscreenChoice FullscreenChoice::fastest() {
    FullscreenChoice choice(FullscreenMethod::Fragment);
    choice.m_measures = true;
    return choice;
}

void FullscreenChoice::beginPass(const char* name) {
    m_now = nullptr;
    m_hasDrawnByCompute = false;
    if (!m_measures) return;
    m_now = &m_passes[name];
    if (!m_now->isDecided) m_now->method = m_now->frames++ % 2 ? FullscreenMethod::Compute : FullscreenMethod::Fragment;
}

double FullscreenChoice::median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

bool FullscreenChoice::isMeasuring() const {
    const auto isOpen = [](const auto& each) { return each.second.isUsed && !each.second.isDecided; };
    return m_measures && (m_passes.empty() || std::any_of(m_passes.begin(), m_passes.end(), isOpen));
}

void FullscreenChoice::addPassTimes(const PassTimer::Times& times) {
    if (!m_measures) return;
    for (const auto& [name, ms, tag] : times) {
        const auto found = m_passes.find(std::string_view(name));
        if (found == m_passes.end() || found->second.isDecided || !found->second.isUsed) continue;
        Pass& pass = found->second;
        std::vector<double>& fragment = pass.ms[size_t(FullscreenMethod::Fragment)];
        std::vector<double>& compute = pass.ms[size_t(FullscreenMethod::Compute)];
        pass.ms[size_t(tag)].push_back(ms);
        if (fragment.size() < kWarmUpFrames + kTimedFrames || compute.size() < kWarmUpFrames + kTimedFrames) continue;
        for (auto* each : {&fragment, &compute}) *each = {median({each->begin() + kWarmUpFrames, each->end()})};
        pass.method = compute[0] < fragment[0] ? FullscreenMethod::Compute : FullscreenMethod::Fragment;
        pass.isDecided = pass.isUnreported = true;
    }
}

std::string FullscreenChoice::takeDecisions() {
    if (isMeasuring()) return {};
    std::ostringstream decisions;
    for (auto& [name, pass] : m_passes) {
        if (!std::exchange(pass.isUnreported, false)) continue;
        const bool byCompute = pass.method == FullscreenMethod::Compute;
        decisions << (decisions.tellp() > 0 ? ", " : "") << name << (byCompute ? " by compute (" : " by fragments (")
                  << std::fixed << std::setprecision(3) << pass.ms[size_t(pass.method)][0] << " ms instead of "
                  << pass.ms[byCompute ? 0 : 1][0] << ")";
    }
    return decisions.str();
}

}  // namespace rubble
