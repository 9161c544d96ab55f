#include "samples/netplay/pose_track.h"

#include <algorithm>
#include <cmath>

namespace netplay {
namespace {

constexpr double kLongestExtrapolation = 6.0;  // steps
constexpr double kWakeSteps = 3.0;             // from the last moment of sleep to the first pose behind it
constexpr size_t kMaxSamples = 32;

/// The pose at a part of the way from one to the other; beyond 1 it goes on.
BodyPose blend(const BodyPose& from, const BodyPose& to, double part) {
    BodyPose out = to;
    for (size_t i = 0; i < 3; ++i) out.position[i] = from.position[i] + (to.position[i] - from.position[i]) * part;
    double dot = 0.0, length = 0.0;
    for (size_t i = 0; i < 4; ++i) dot += from.rotation[i] * to.rotation[i];
    for (size_t i = 0; i < 4; ++i) {
        const double begin = dot < 0.0 ? -from.rotation[i] : from.rotation[i];
        out.rotation[i] = begin + (to.rotation[i] - begin) * part;
        length += out.rotation[i] * out.rotation[i];
    }
    if (length < 1e-6) return to;
    for (double& value : out.rotation) value /= std::sqrt(length);
    out.isAsleep = part >= 1.0 && to.isAsleep;
    return out;
}

}  // namespace

void PoseTrack::add(uint64_t step, const BodyPose& pose) {
    const auto at = std::lower_bound(m_samples.begin(), m_samples.end(), step,
                                     [](const Sample& sample, uint64_t value) { return sample.step < value; });
    if (at != m_samples.end() && at->step == step) return;
    if (at == m_samples.begin() && m_samples.size() >= kMaxSamples) return;
    m_samples.insert(at, {step, pose});
    if (m_samples.size() > kMaxSamples) m_samples.erase(m_samples.begin());
}

std::optional<BodyPose> PoseTrack::at(double time) const {
    if (m_samples.empty() || time < double(m_samples.front().step)) return std::nullopt;
    const auto later = std::upper_bound(m_samples.begin(), m_samples.end(), time,
                                        [](double value, const Sample& sample) { return value < double(sample.step); });
    const Sample& from = *(later - 1);
    if (later != m_samples.end()) {
        const double end = double(later->step);
        const double begin = from.pose.isAsleep ? std::max(double(from.step), end - kWakeSteps) : double(from.step);
        return time <= begin ? from.pose : blend(from.pose, later->pose, (time - begin) / (end - begin));
    }
    if (from.pose.isAsleep || m_samples.size() < 2 || (later - 2)->pose.isAsleep) return from.pose;
    const Sample& before = *(later - 2);
    const double ahead = std::min(time - double(from.step), kLongestExtrapolation);
    return blend(before.pose, from.pose, 1.0 + ahead / double(from.step - before.step));
}

bool PoseTrack::isAtRest(double time) const {
    return m_samples.empty() || (m_samples.back().pose.isAsleep && time >= double(m_samples.back().step));
}

void PoseTrack::forgetBefore(double time) {
    while (m_samples.size() > 2 && double(m_samples[1].step) < time && double(m_samples[2].step) <= time)
        m_samples.erase(m_samples.begin());
}

}  // namespace netplay
