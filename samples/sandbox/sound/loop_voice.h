#pragma once
#include <array>
#include <string_view>

#include "samples/sandbox/sound/resonators.h"

namespace sandbox::sound {

/// A sound that goes on: noise in two bands that swells and ebbs, and hits on a body, at random or in time.
struct LoopKind {
    std::string_view name;
    struct Band {
        double center, width, level;
    } bands[2];
    double swell, swellRate;  ///< share of the level that comes and goes, and Hz
    double rate;              ///< hits a second
    bool isPeriodic;          ///< in time, as an engine's; else as they come
    std::string_view material;
    double size;  ///< metres of the body
    double level, contact;
};

/// The row of a name, or null.
const LoopKind* findLoopKind(std::string_view name);

/// One such sound that plays.
class LoopVoice {
public:
    /// Silent; two of a kind with other seeds differ as two fires do.
    LoopVoice(const LoopKind& kind, uint32_t seed);
    /// Adds a block whose gain goes from that of the last one to `gain`, at `pitch` times the kind's rate of hits.
    void render(float* out, float gain, double pitch);
    /// That it has come to.
    float gain() const { return m_gain; }

private:
    const LoopKind& m_kind;
    Random m_random;
    NoiseBand m_bands[2];
    Resonators m_body;
    double m_due = 0.0, m_phase = 0.0;
    float m_gain = 0.0f;
};

}  // namespace sandbox::sound
