#include "samples/sandbox/sound/loop_voice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandbox::sound {
namespace {

// Found by ear and by spectrogram.
constexpr LoopKind kKinds[] = {
    // bands: Hz, width, level; swell, Hz; hits/s, in time; body, m, level, contact
    {"fire", {{170, 1.2, .55}, {1100, 1.6, .10}}, .45, 2.3, 16, false, "wood", .10, .90, 4e-5},
    {"water", {{900, 1.6, .10}, {3200, 1.6, .04}}, .25, .7, 70, false, "bubbles", .10, .30, 1e-3},
    {"wind", {{240, .35, .80}, {900, .50, .20}}, .65, .21, 0, false, "generic", .10, 0, 1e-3},
    {"rain", {{4500, 1.6, .16}, {1500, 1.4, .05}}, .10, .3, 90, false, "plaster", .10, .10, 1e-4},
    {"engine", {{120, 1.0, .10}, {700, 1.4, .05}}, .05, 3.0, 42, true, "rubber", .50, 2.2, 5e-3},
    {"motor", {{420, .8, .10}, {2600, 1.0, .04}}, .05, 5.0, 96, true, "plastic", .30, .45, 6e-4},
    {"jet", {{1300, 1.3, .50}, {5200, 1.5, .25}}, .12, 7.0, 0, false, "generic", .10, 0, 1e-3},
    {"rocket", {{260, 1.2, .80}, {2200, 1.5, .35}}, .20, 9.0, 0, false, "generic", .10, 0, 1e-3},
    {"alarm", {{900, 1.0, 0}, {2000, 1.0, 0}}, 0, 1.0, 14, true, "heavy metal", .16, 2.0, 1e-4},
};

}  // namespace

const LoopKind* findLoopKind(std::string_view name) {
    const auto* row = std::find_if(std::begin(kKinds), std::end(kKinds), [&](const auto& k) { return k.name == name; });
    return row == std::end(kKinds) ? nullptr : row;
}

LoopVoice::LoopVoice(const LoopKind& kind, uint32_t seed) : m_kind(kind), m_random(seed) {
    for (int i = 0; i < 2; ++i) m_bands[i].set(kind.bands[i].center, 1.0, kind.bands[i].width);
    m_body.set(acousticMaterials()[findAcousticMaterial(kind.material)], {kind.size, 0.8 * kind.size, 0.6 * kind.size});
    m_phase = m_random.unit();
}

void LoopVoice::render(float* out, float gain, double pitch) {
    constexpr int kPart = 50;  ///< samples: no hit is further from its time
    std::array<float, kBlock> block{};
    m_phase += m_kind.swellRate * kBlock / kSampleRate;
    const double wave = std::sin(2.0 * std::numbers::pi * m_phase) + 0.6 * std::sin(1.7 * std::numbers::pi * m_phase);
    for (int i = 0; i < 2; ++i) m_bands[i].hold(float(m_kind.bands[i].level * (1.0 + m_kind.swell * 0.5 * wave)));
    const double rate = m_kind.rate * std::max(pitch, 0.0) / kSampleRate;
    for (int at = 0; at < kBlock; at += kPart) {
        for (m_due -= kPart * rate; m_due < 0.0; m_due += m_kind.isPeriodic ? 1.0 : double(m_random.exponential())) {
            const float strength = m_kind.isPeriodic ? 0.9f + 0.1f * m_random.unit() : m_random.exponential();
            m_body.strike(float(m_kind.level) * std::min(strength, 4.0f), m_kind.contact, m_random);
        }
        m_body.render(block.data() + at, kPart, m_random);
        for (NoiseBand& band : m_bands) band.render(block.data() + at, kPart, m_random);
    }
    for (int i = 0; i < kBlock; ++i) out[i] += block[size_t(i)] * (m_gain + (gain - m_gain) * float(i) / kBlock);
    m_gain = gain;
}

}  // namespace sandbox::sound
