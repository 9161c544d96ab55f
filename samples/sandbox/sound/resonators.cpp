#include "samples/sandbox/sound/resonators.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandbox::sound {
namespace {

using std::numbers::pi;

constexpr float kAttack = 1.0f / 48.0f;  ///< share of the way to its level that noise takes in a sample
constexpr float kSilence = 1e-7f;
constexpr float kPush = 0.12f;  ///< how loud the push is beside the modes

}  // namespace

/// Zavalishin, The Art of VA Filter Design, 4: the filter whose integrators are trapezoidal.
void NoiseBand::set(double center, double decay, double width) {
    m_g = float(std::tan(pi * std::min(center, 0.4 * kSampleRate) / kSampleRate));
    m_k = float(width);
    m_fall = float(std::exp(-1.0 / (std::max(decay, 1e-3) * kSampleRate)));
}

void NoiseBand::add(float amplitude) {
    m_goal = std::sqrt(m_goal * m_goal + amplitude * amplitude);
}

void NoiseBand::render(float* out, int count, Random& random) {
    if (m_goal + m_now + m_held < kSilence) {
        m_goal = m_now = m_low = m_band = 0;
        return;
    }
    const float a1 = 1.0f / (1.0f + m_g * (m_g + m_k)), a2 = m_g * a1, a3 = m_g * a2;
    for (int i = 0; i < count; ++i) {
        const float in = random.sign(), v3 = in - m_low;
        const float v1 = a1 * m_band + a2 * v3, v2 = m_low + a2 * m_band + a3 * v3;
        m_band = 2.0f * v1 - m_band;
        m_low = 2.0f * v2 - m_low;
        m_goal *= m_fall;
        m_now += (m_goal + m_held - m_now) * kAttack;
        out[i] += m_now * m_k * v1;
    }
}

void Resonators::setMode(size_t i, double frequency, double decay) {
    const double size = std::exp(-decay / kSampleRate), angle = 2.0 * pi * frequency / kSampleRate;
    m_turnRe[i / kLanes][i % kLanes] = float(size * std::cos(angle));
    m_turnIm[i / kLanes][i % kLanes] = float(size * std::sin(angle));
}

void Resonators::set(const AcousticMaterial& material, const std::array<double, 3>& size) {
    const Modes modes = modesOf(material, size);
    for (size_t row = 0; row < kRows; ++row) m_re[row] = m_im[row] = m_turnRe[row] = m_turnIm[row] = Lanes{};
    for (size_t i = 0; i < kModes; ++i) {
        setMode(i, modes[i].frequency, modes[i].decay);
        m_gain[i] = float(modes[i].gain * (1.0 - material.noise) * material.level);
        m_frequency[i] = float(modes[i].frequency);
    }
    m_noise = {};
    m_noise.set(material.noiseCenter, material.noiseDecay);
    m_noiseShare = float(material.noise * material.level);
    m_isSparse = material.vibration == Vibration::Bubbles;
}

void Resonators::strike(float amplitude, double seconds, Random& random) {
    for (size_t i = 0; i < kModes; ++i) {
        const float x = random.sign(), softness = 2.0f * m_frequency[i] * float(seconds);
        const float place = m_isSparse ? x * x * x * x * x * x * x : x < 0 ? 0.7f * x - 0.3f : 0.7f * x + 0.3f;
        // Begins at 0, as a sine does. The spectrum of a push that long falls by 12 dB an octave above 1 / (2 t).
        m_im[i / kLanes][i % kLanes] += amplitude * m_gain[i] * place / (1.0f + softness * softness);
    }
    if (!m_isSparse) {
        const double frequency = std::clamp(0.35 / seconds, 40.0, 1500.0) * (1.0 + 0.25 * double(random.sign()));
        setMode(kModes, frequency, std::min(3.0 * frequency, 2300.0));
        m_im[kRows - 1][0] += amplitude * kPush * (1.0f - m_noiseShare * 0.5f);
    }
    m_noise.add(amplitude * m_noiseShare);
}

void Resonators::render(float* out, int count, Random& random) {
    for (int s = 0; s < count; ++s) {
        Lanes sum{};
        for (size_t row = 0; row < kRows; ++row) {
            const Lanes re = m_re[row] * m_turnRe[row] - m_im[row] * m_turnIm[row];
            m_im[row] = m_re[row] * m_turnIm[row] + m_im[row] * m_turnRe[row];
            m_re[row] = re;
            sum += re;
        }
        out[s] += sum[0] + sum[1] + sum[2] + sum[3];
    }
    m_noise.render(out, count, random);
    for (size_t i = 0; i <= kModes; ++i)  // what has died away stays away from denormals
        if (std::abs(m_re[i / kLanes][i % kLanes]) + std::abs(m_im[i / kLanes][i % kLanes]) < kSilence)
            m_re[i / kLanes][i % kLanes] = m_im[i / kLanes][i % kLanes] = 0.0f;
}

float Resonators::level() const {
    float sum = m_noise.level();
    for (size_t i = 0; i <= kModes; ++i)
        sum += std::abs(m_re[i / kLanes][i % kLanes]) + std::abs(m_im[i / kLanes][i % kLanes]);
    return sum;
}

}  // namespace sandbox::sound
