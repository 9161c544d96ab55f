#include "samples/sandbox/sound/sound.h"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <utility>

#include "samples/sandbox/sound/named_sounds.h"

namespace sandbox::sound {
namespace {

constexpr size_t kStrikes = 12;       ///< of a step, after those near each other were joined
constexpr int kRoomBlocks = 15;       ///< from one room to the next: reverberation changes slowly
constexpr double kLoopSeconds = 0.1;  ///< that a loop goes on without another call
constexpr double kSameLoop = 2.0;     ///< metres that one moves from call to call
constexpr double kBlockSeconds = double(kBlock) / kSampleRate;

}  // namespace

Sound::Sound(const rubble_api& api, const std::string& wav, bool wantsCard,
             const std::function<void(const std::string&)>& log)
    : m_api(api) {
    if (wav.empty() && !wantsCard) return;
    std::string why;
    m_output = wav.empty() ? Output::openDevice(why) : Output::openMemory(why);
    if (!wav.empty() && m_output) m_wav = WavFile::create(wav, 2, m_error);
    if (!m_error.empty()) m_output.reset(), why = m_error;
    if (!m_output) {
        log("no sound: " + why);
        return;
    }
    if (wav.empty()) m_thread = std::jthread([this](std::stop_token stop) { playCard(std::move(stop)); });
}

Sound::~Sound() = default;

void Sound::enter(rubble_world world) {
    m_world.reset();
    m_acoustics.reset();
    if (world) m_world.emplace(m_api, world), m_acoustics.emplace(m_api, world);
}

rubble_report_filter Sound::filter() const {
    rubble_report_filter none = {};
    none.struct_size = sizeof none;
    return isOn() ? WorldSounds::filter() : none;
}

void Sound::play(const std::string& name, std::optional<glm::dvec3> position, double volume) {
    if (!isOn()) return;
    for (const Strike& strike : soundStrikes(name, position.value_or(m_ear), volume)) m_strikes.push_back(strike);
}

void Sound::loop(const std::string& name, std::optional<glm::dvec3> position, double volume, double pitch) {
    const LoopKind* kind = findLoopKind(name);
    if (!isOn() || !kind) return;
    const auto same = std::find_if(m_played.begin(), m_played.end(), [&](const Played& other) {
        if (other.loop.kind != kind || other.loop.isAtEar == position.has_value()) return false;
        return !position || glm::distance(other.loop.position, *position) < kSameLoop;
    });
    Played& played = same != m_played.end() ? *same : m_played.emplace_back();
    if (same == m_played.end()) played.loop.id = ++m_loopCount;
    played.left = kLoopSeconds;
    played.loop.kind = kind;
    played.loop.position = position.value_or(m_ear);
    played.loop.gain = std::clamp(volume, 0.0, 4.0);
    played.loop.pitch = std::clamp(pitch, 0.1, 8.0);
    played.loop.isAtEar = !position;
}

void Sound::step() {
    if (isOn() && m_world) m_world->read(m_strikes);
}

/// Walls between, for all that begins in this frame and all that goes on.
void Sound::openness() {
    m_places.clear();
    for (const Strike& strike : m_strikes) m_places.push_back(strike.position);
    for (const Loop& loop : m_loops) m_places.push_back(loop.position);
    m_acoustics->findOpenness(m_places, m_openness);
    for (size_t i = 0; i < m_strikes.size(); ++i) m_strikes[i].openness = m_openness[i];
    for (size_t i = 0; i < m_loops.size(); ++i)
        if (!m_loops[i].isAtEar) m_loops[i].openness = m_openness[m_strikes.size() + i];
}

void Sound::frame(double seconds, glm::dvec3 ear, const std::array<double, 4>& rotation) {
    if (!m_output) return;
    m_ear = ear;
    m_loops.clear();
    for (Played& played : m_played) m_loops.push_back(played.loop), played.left -= seconds;
    std::erase_if(m_played, [](const Played& played) { return played.left <= 0.0; });
    if (isOn() && m_world) {
        m_world->readFires(ear, m_loops);
        m_acoustics->listen(ear);
        m_strikes = joinStrikes(m_strikes, ear, kStrikes);
        openness();
    }
    {
        const std::lock_guard lock(m_mutex);
        m_inbox.strikes.insert(m_inbox.strikes.end(), m_strikes.begin(), m_strikes.end());
        m_inbox.loops = m_loops;
        m_inbox.ear = ear, m_inbox.rotation = rotation;
        m_inbox.volume = m_volume;
        if (m_acoustics) m_inbox.room = m_acoustics->room();
    }
    m_strikes.clear();
    if (!m_wav) return;
    for (m_due += seconds; m_due >= kBlockSeconds - 1e-9; m_due -= kBlockSeconds) {
        nextBlock();
        m_output->read(m_samples);
        if (!m_wav->write(m_samples) && m_error.empty()) m_error = "the WAV file could not be written";
    }
}

void Sound::nextBlock() {
    Inbox inbox;
    {
        const std::lock_guard lock(m_mutex);
        inbox.strikes.swap(m_inbox.strikes);
        inbox.loops = m_inbox.loops;
        inbox.ear = m_inbox.ear, inbox.rotation = m_inbox.rotation;
        inbox.room = m_inbox.room, inbox.volume = m_inbox.volume;
    }
    m_mixer.listen(inbox.ear);
    for (const Strike& strike : inbox.strikes) m_mixer.add(strike);
    m_mixer.setLoops(inbox.loops);
    m_mixer.render();
    if (--m_untilRoom <= 0) m_output->setRoom(inbox.room), m_untilRoom = kRoomBlocks;
    m_output->setVolume(inbox.volume);
    m_output->play(m_mixer.emitters(), inbox.ear, inbox.rotation);
}

void Sound::playCard(std::stop_token stop) {
    while (!stop.stop_requested()) {
        while (m_output->wantsBlock()) nextBlock();
        std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
}

}  // namespace sandbox::sound
