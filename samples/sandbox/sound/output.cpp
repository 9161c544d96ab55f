#include "samples/sandbox/sound/output.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <AL/efx.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sandbox::sound {
namespace {

constexpr size_t kAhead = 3;          ///< blocks that a card has in hand: 50 ms
constexpr size_t kBuffers = 8;        ///< of a source
constexpr float kReference = 4.0f;    ///< metres at which a sound is as loud as it was made; beyond, 1 / distance
constexpr float kHeadroom = 0.95f;    ///< of a file, so that it keeps away from the full scale
constexpr double kAbsorption = 0.12;  ///< of walls, and of what stands in rooms

/// The functions of OpenAL's extensions, which are asked for by name.
struct Extensions {
    LPALGENEFFECTS genEffects;
    LPALEFFECTI effecti;
    LPALEFFECTF effectf;
    LPALGENFILTERS genFilters;
    LPALFILTERI filteri;
    LPALFILTERF filterf;
    LPALGENAUXILIARYEFFECTSLOTS genSlots;
    LPALAUXILIARYEFFECTSLOTI sloti;
    LPALAUXILIARYEFFECTSLOTF slotf;
    LPALCLOOPBACKOPENDEVICESOFT openLoopback;
    LPALCRENDERSAMPLESSOFT renderSamples;
};

template <class Function>
void load(Function& function, const char* name) {
    function = reinterpret_cast<Function>(alGetProcAddress(name));
}

/// Opens a card without what ALSA writes to standard error where there is none: not having one is no error.
ALCdevice* openCard() {
    const int kept = dup(STDERR_FILENO), nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    ALCdevice* device = alcOpenDevice(nullptr);
    if (kept >= 0) dup2(kept, STDERR_FILENO), close(kept);
    if (nowhere >= 0) close(nowhere);
    return device;
}

/// A source with the buffers that go round through it.
struct Source {
    ALuint name = 0;
    std::array<ALuint, kBuffers> buffers{};
    std::vector<ALuint> free;
};

}  // namespace

double reverberationTime(const Room& room) {
    const double absorption = room.openness + (1.0 - room.openness) * kAbsorption;
    return std::clamp(0.161 / 4.0 * room.freePath / absorption, 0.1, 8.0);
}

struct Output::Al {
    ALCdevice* device = nullptr;
    ALCcontext* context = nullptr;
    bool isMemory = false;
    Extensions extensions{};
    ALuint effect = 0, slot = 0, direct = 0, send = 0;
    std::array<Source, kEmitters> sources;
    Source clock;  ///< plays silence all the time: how far a card has come
    double wet = 0.0;

    ~Al() {
        alcMakeContextCurrent(nullptr);
        if (context) alcDestroyContext(context);  // with all that was made in it
        if (device) alcCloseDevice(device);
    }

    std::string makeContext() {
        const ALCint attributes[] = {ALC_FREQUENCY, kSampleRate, ALC_MONO_SOURCES, int(kEmitters) + 2,
                                     ALC_MAX_AUXILIARY_SENDS, 1, ALC_OUTPUT_LIMITER_SOFT, ALC_TRUE,
                                     // of memory alone
                                     ALC_FORMAT_CHANNELS_SOFT, ALC_STEREO_SOFT, ALC_FORMAT_TYPE_SOFT, ALC_FLOAT_SOFT,
                                     ALC_HRTF_SOFT, ALC_FALSE, 0};
        ALCint ofDevice[std::size(attributes)];
        std::copy(std::begin(attributes), std::end(attributes), ofDevice);
        if (!isMemory) ofDevice[8] = 0;
        context = alcCreateContext(device, ofDevice);
        if (!context || !alcMakeContextCurrent(context)) return "OpenAL could not make a context";
        if (!alcIsExtensionPresent(device, "ALC_EXT_EFX") || !alIsExtensionPresent("AL_EXT_FLOAT32"))
            return "OpenAL is without effects or samples of float";
        return "";
    }

    void makeObjects() {
        Extensions& e = extensions;
        load(e.genEffects, "alGenEffects"), load(e.effecti, "alEffecti"), load(e.effectf, "alEffectf");
        load(e.genFilters, "alGenFilters"), load(e.filteri, "alFilteri"), load(e.filterf, "alFilterf");
        load(e.genSlots, "alGenAuxiliaryEffectSlots"), load(e.sloti, "alAuxiliaryEffectSloti");
        load(e.slotf, "alAuxiliaryEffectSlotf");
        e.genEffects(1, &effect), e.genSlots(1, &slot), e.genFilters(1, &direct), e.genFilters(1, &send);
        e.effecti(effect, AL_EFFECT_TYPE, AL_EFFECT_EAXREVERB);
        e.filteri(direct, AL_FILTER_TYPE, AL_FILTER_LOWPASS);
        e.filteri(send, AL_FILTER_TYPE, AL_FILTER_LOWPASS);
        e.sloti(slot, AL_EFFECTSLOT_AUXILIARY_SEND_AUTO, AL_FALSE);
        alDistanceModel(AL_INVERSE_DISTANCE_CLAMPED);
        for (Source& source : sources) makeSource(source);
        makeSource(clock);
        alSourcef(clock.name, AL_GAIN, 0.0f);
    }

    void makeSource(Source& source) {
        alGenSources(1, &source.name);
        alGenBuffers(ALsizei(kBuffers), source.buffers.data());
        source.free.assign(source.buffers.begin(), source.buffers.end());
        alSourcef(source.name, AL_REFERENCE_DISTANCE, kReference);
        alSourcef(source.name, AL_AIR_ABSORPTION_FACTOR, 1.0f);
    }

    void takeBack(Source& source) {
        ALint done = 0;
        alGetSourcei(source.name, AL_BUFFERS_PROCESSED, &done);
        for (ALuint buffer; done > 0; --done) {
            alSourceUnqueueBuffers(source.name, 1, &buffer);
            source.free.push_back(buffer);
        }
    }

    void queue(Source& source, const float* samples) {
        if (source.free.empty()) return;
        const ALuint buffer = source.free.back();
        source.free.pop_back();
        alBufferData(buffer, AL_FORMAT_MONO_FLOAT32, samples, kBlock * int(sizeof(float)), kSampleRate);
        alSourceQueueBuffers(source.name, 1, &buffer);
    }

    /// Queues a block behind `lead` silent ones if the source does not play.
    void playBlock(Source& source, const float* samples, size_t lead) {
        static constexpr std::array<float, kBlock> kSilence{};
        takeBack(source);
        ALint state = 0;
        alGetSourcei(source.name, AL_SOURCE_STATE, &state);
        const bool plays = state == AL_PLAYING;
        for (size_t i = 0; i < lead && !plays; ++i) queue(source, kSilence.data());
        queue(source, samples);
        if (!plays) alSourcePlay(source.name);
    }

    /// What is between takes high tones more than low ones.
    void place(Source& source, const Emitter& emitter, const glm::dvec3& ear) {
        const glm::dvec3 at = emitter.isAtEar ? glm::dvec3(0.0) : emitter.position - ear;
        alSource3f(source.name, AL_POSITION, float(at.x), float(at.y), float(at.z));
        const float open = float(std::clamp(emitter.openness, 0.0, 1.0));
        extensions.filterf(direct, AL_LOWPASS_GAIN, 0.30f + 0.70f * open);
        extensions.filterf(direct, AL_LOWPASS_GAINHF, 0.06f + 0.94f * open * open);
        alSourcei(source.name, AL_DIRECT_FILTER, ALint(direct));
        extensions.filterf(send, AL_LOWPASS_GAIN, emitter.isAtEar ? 0.0f : float(wet) * (0.5f + 0.5f * open));
        extensions.filterf(send, AL_LOWPASS_GAINHF, 0.4f + 0.6f * open);
        alSource3i(source.name, AL_AUXILIARY_SEND_FILTER, ALint(slot), 0, ALint(send));
    }
};

Output::Output(std::unique_ptr<Al> al) : m_al(std::move(al)) {}
Output::~Output() = default;

std::unique_ptr<Output> Output::openDevice(std::string& why) {
    auto al = std::make_unique<Al>();
    al->device = openCard();
    const char* name = al->device ? alcGetString(al->device, ALC_ALL_DEVICES_SPECIFIER) : "No Output";
    if (!name || std::strcmp(name, "No Output") == 0) return why = "there is no sound card", nullptr;
    why = al->makeContext();
    if (!why.empty()) return nullptr;
    al->makeObjects();
    return std::unique_ptr<Output>(new Output(std::move(al)));
}

std::unique_ptr<Output> Output::openMemory(std::string& why) {
    auto al = std::make_unique<Al>();
    al->isMemory = true;
    if (!alcIsExtensionPresent(nullptr, "ALC_SOFT_loopback")) return why = "OpenAL cannot play to memory", nullptr;
    auto& e = al->extensions;
    e.openLoopback =
        reinterpret_cast<LPALCLOOPBACKOPENDEVICESOFT>(alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT"));
    e.renderSamples = reinterpret_cast<LPALCRENDERSAMPLESSOFT>(alcGetProcAddress(nullptr, "alcRenderSamplesSOFT"));
    al->device = e.openLoopback(nullptr);
    why = al->device ? al->makeContext() : "OpenAL cannot play to memory";
    if (!why.empty()) return nullptr;
    al->makeObjects();
    return std::unique_ptr<Output>(new Output(std::move(al)));
}

bool Output::wantsBlock() {
    m_al->takeBack(m_al->clock);
    return kBuffers - m_al->clock.free.size() < kAhead;
}

void Output::play(const std::array<Emitter, kEmitters>& emitters, glm::dvec3 ear, const std::array<double, 4>& r) {
    static constexpr std::array<float, kBlock> kSilence{};
    const glm::dquat rotation(r[3], r[0], r[1], r[2]);
    const glm::vec3 ahead(rotation * glm::dvec3(0, 0, -1)), up(rotation * glm::dvec3(0, 1, 0));
    const float orientation[] = {ahead.x, ahead.y, ahead.z, up.x, up.y, up.z};
    alcSuspendContext(m_al->context);
    alListenerfv(AL_ORIENTATION, orientation);
    m_al->playBlock(m_al->clock, kSilence.data(), 0);
    const size_t lead = m_al->isMemory ? 0 : kBuffers - m_al->clock.free.size() - 1;
    for (size_t i = 0; i < kEmitters; ++i) {
        if (!emitters[i].isActive) continue;
        m_al->place(m_al->sources[i], emitters[i], ear);
        m_al->playBlock(m_al->sources[i], emitters[i].block.data(), lead);
    }
    alcProcessContext(m_al->context);
}

void Output::read(std::vector<float>& samples) {
    samples.resize(2 * kBlock);
    m_al->extensions.renderSamples(m_al->device, samples.data(), kBlock);
    for (float& sample : samples) sample *= kHeadroom;
}

void Output::setRoom(const Room& room) {
    const Extensions& e = m_al->extensions;
    const ALuint effect = m_al->effect;
    const double path = std::clamp(room.freePath, 0.5, 60.0);
    e.effectf(effect, AL_EAXREVERB_DECAY_TIME, float(reverberationTime(room)));
    e.effectf(effect, AL_EAXREVERB_DECAY_HFRATIO, 0.6f);
    e.effectf(effect, AL_EAXREVERB_GAIN, 0.6f);
    e.effectf(effect, AL_EAXREVERB_GAINHF, 0.7f);
    e.effectf(effect, AL_EAXREVERB_DENSITY, float(std::clamp(path / 10.0, 0.1, 1.0)));
    e.effectf(effect, AL_EAXREVERB_REFLECTIONS_DELAY, float(std::min(path / 343.0, 0.3)));
    e.effectf(effect, AL_EAXREVERB_LATE_REVERB_DELAY, float(std::min(path / 343.0, 0.1)));
    e.sloti(m_al->slot, AL_EFFECTSLOT_EFFECT, ALint(effect));
    m_al->wet = std::clamp(1.0 - room.openness, 0.0, 1.0);
}

void Output::setVolume(double volume) {
    alListenerf(AL_GAIN, float(volume));
}

}  // namespace sandbox::sound
