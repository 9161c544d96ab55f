#pragma once
#include <rubble/rubble.h>

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "samples/sandbox/sound/acoustics.h"
#include "samples/sandbox/sound/mixer.h"
#include "samples/sandbox/sound/output.h"
#include "samples/sandbox/sound/wav_file.h"
#include "samples/sandbox/sound/world_sounds.h"

namespace sandbox::sound {

/// The sound of a game: what its world reports and what its scripts play, by a sound card or into a WAV file. Where
/// there is neither, or the volume is 0, nothing is asked of the world and nothing is computed.
///
///     sound.enter(world);
///     for (;;) {
///         while (a step is due) api.step(world), sound.step();
///         sound.frame(secondsOfTheFrame, ear, rotation);
///     }
class Sound {
public:
    /// `wav`: a file in place of a card; "": a card, if one is wanted. The line says why there is no sound.
    Sound(const rubble_api& api, const std::string& wav, bool wantsCard,
          const std::function<void(const std::string&)>& log);
    ~Sound();
    Sound(const Sound&) = delete;
    Sound& operator=(const Sound&) = delete;

    /// Whether anybody hears something.
    bool isOn() const { return m_output && m_volume > 0.0; }
    /// Goes on with a world, which must outlive that; 0: with none.
    void enter(rubble_world world);
    /// What the world shall report; nothing while there is no sound.
    rubble_report_filter filter() const;
    /// 0: off, to 1.
    void setVolume(double volume) { m_volume = volume; }

    /// A sound by its name, see named_sounds.h; at a place, or without one before the eyes.
    void play(const std::string& name, std::optional<glm::dvec3> position, double volume);
    /// A sound that goes on, see loop_voice.cpp, for as long as this is called in each frame or step.
    void loop(const std::string& name, std::optional<glm::dvec3> position, double volume, double pitch);

    /// After each step of the world.
    void step();
    /// After the steps of a frame.
    void frame(double seconds, glm::dvec3 ear, const std::array<double, 4>& rotation);
    /// Completes the WAV file; there is no sound from then on.
    void close() { m_wav.reset(), m_output.reset(); }
    /// What could not be written, or "".
    const std::string& error() const { return m_error; }

private:
    /// What the mixer gets for its next block.
    struct Inbox {
        std::vector<Strike> strikes;
        std::vector<Loop> loops;
        glm::dvec3 ear{0.0};
        std::array<double, 4> rotation{0.0, 0.0, 0.0, 1.0};
        Room room;
        double volume = 1.0;
    };
    struct Played {
        Loop loop;
        double left = 0.0;  ///< seconds
    };
    void openness();
    void nextBlock();
    void playCard(std::stop_token stop);

    const rubble_api& m_api;
    std::unique_ptr<Output> m_output;
    std::unique_ptr<WavFile> m_wav;
    std::optional<WorldSounds> m_world;
    std::optional<Acoustics> m_acoustics;
    std::vector<Strike> m_strikes;
    std::vector<Loop> m_loops;
    std::vector<Played> m_played;  ///< loops of scripts
    uint64_t m_loopCount = 0;
    std::vector<glm::dvec3> m_places;
    std::vector<double> m_openness;
    std::vector<float> m_samples;
    glm::dvec3 m_ear{0.0};
    double m_volume = 1.0, m_due = 0.0;
    std::string m_error;
    std::mutex m_mutex;  ///< of the inbox
    Inbox m_inbox;
    Mixer m_mixer;          ///< of the thread that plays
    int m_untilRoom = 0;    ///< blocks until the room is told to OpenAL
    std::jthread m_thread;  ///< plays by the card; ends first
};

}  // namespace sandbox::sound
