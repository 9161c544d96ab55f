#pragma once
#include <array>
#include <list>
#include <map>
#include <optional>
#include <vector>

#include "samples/sandbox/sound/loop_voice.h"
#include "samples/sandbox/sound/resonators.h"
#include "samples/sandbox/sound/strike.h"

namespace sandbox::sound {

inline constexpr size_t kBodies = 48;  ///< bodies that sound at a time
inline constexpr size_t kPlaces = 24;  ///< places at which they are
inline constexpr size_t kLoops = 8;    ///< sounds that go on
inline constexpr size_t kEmitters = kPlaces + kLoops;

/// A sound that goes on, as it is in a step.
struct Loop {
    uint64_t id = 0;  ///< of one and the same sound from step to step
    const LoopKind* kind = nullptr;
    glm::dvec3 position{0.0};
    double gain = 1.0, pitch = 1.0, openness = 1.0;
    bool isAtEar = false;  ///< comes from all around
};

/// What one place gives in a block.
struct Emitter {
    bool isActive = false;
    glm::dvec3 position{0.0};
    double openness = 1.0;
    bool isAtEar = false;
    std::array<float, kBlock> block{};
};

/// Makes the sound of strikes and loops, block by block, each at its place. What is struck goes on sounding: further
/// hits excite the same body. With more bodies than kBodies the quietest one fades out in a block, with more places the
/// closest one takes the strike. The same strikes give the same samples.
class Mixer {
public:
    /// Where loudness is judged from.
    void listen(glm::dvec3 ear) { m_ear = ear; }
    /// Strikes that begin with the next block.
    void add(const Strike& strike) { m_waiting.push_back(strike); }
    /// All loops that sound from now on; others fade out.
    void setLoops(const std::vector<Loop>& loops) { m_wanted = loops; }
    /// The next kBlock samples of each place.
    void render();
    /// What render() gave.
    const std::array<Emitter, kEmitters>& emitters() const { return m_emitters; }
    /// How many bodies sound.
    size_t bodies() const;

private:
    struct Hit {
        int due;  ///< samples from the begin of the next block
        float amplitude, contact;
    };
    struct Body {
        bool isUsed = false, fades = false;
        size_t emitter = 0, material = 0;
        std::array<double, 3> size{};
        Resonators resonators;
        std::vector<Hit> hits;
    };
    struct PlayingLoop {
        Loop state;
        bool isWanted = true;
        LoopVoice voice;
    };
    bool begin(const Strike& strike);
    size_t emitterFor(const Strike& strike);
    Body* bodyFor(const Strike& strike, size_t emitter);
    Body* quietest();
    void scatter(Body& body, const Strike& strike);
    void renderBody(Body& body);
    void followLoops();
    void renderLoops();

    glm::dvec3 m_ear{0.0};
    std::vector<Strike> m_waiting;
    std::vector<Loop> m_wanted;
    std::array<Emitter, kEmitters> m_emitters;
    std::array<Body, kBodies> m_bodies;
    std::array<std::optional<PlayingLoop>, kLoops> m_loops;
    Random m_random{1};
};

}  // namespace sandbox::sound
