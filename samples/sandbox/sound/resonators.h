#pragma once
#include <array>

#include "samples/sandbox/sound/modes.h"
#include "samples/sandbox/sound/random.h"

namespace sandbox::sound {

inline constexpr int kSampleRate = 48000;
inline constexpr int kBlock = 800;  ///< samples of a step of 1/60 s

/// Noise through a band-pass filter, whose level falls: what does not ring of a hit.
class NoiseBand {
public:
    /// Hz, s until its level has fallen to 1/e, and width: 0.1 whistles, 1.4 is noise.
    void set(double center, double decay, double width = 1.4);
    /// Adds to its level, in the sense of energy.
    void add(float amplitude);
    /// Moves its level towards one that stays.
    void hold(float level) { m_held = level; }
    /// Adds sound to a part of a block.
    void render(float* out, int count, Random& random);
    /// Its level.
    float level() const { return m_goal + m_held; }

private:
    float m_g = 0, m_k = 1, m_low = 0, m_band = 0;  ///< state-variable filter
    float m_goal = 0, m_now = 0, m_fall = 1, m_held = 0;
};

/// A body that vibrates: kModes resonators, one more for the air that a hit pushes, and noise. The sound is linear in
/// what strikes it, so that any number of hits are the same work.
class Resonators {
public:
    /// Silent, with other modes.
    void set(const AcousticMaterial& material, const std::array<double, 3>& size);
    /// A hit. A soft one, which lasts longer, excites low modes alone. Elsewhere on the body it excites others.
    void strike(float amplitude, double seconds, Random& random);
    /// Adds sound to a part of a block.
    void render(float* out, int count, Random& random);
    /// How loud it is: the sum of its amplitudes.
    float level() const;

private:
    static constexpr size_t kLanes = 4, kRows = kModes / kLanes + 1;  ///< the last row: what a hit pushes
    typedef float Lanes __attribute__((vector_size(16)));
    Lanes m_re[kRows], m_im[kRows], m_turnRe[kRows], m_turnIm[kRows];
    void setMode(size_t i, double frequency, double decay);
    std::array<float, kModes> m_gain{}, m_frequency{};
    NoiseBand m_noise;
    float m_noiseShare = 0;
    bool m_isSparse = false;  ///< a hit excites few of its modes: each bubble is one
};

}  // namespace sandbox::sound
