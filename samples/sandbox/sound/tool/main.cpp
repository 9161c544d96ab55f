// Writes what the game can sound like as WAV files, to listen to and to look at as spectrograms: ./rubble sounds.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "samples/sandbox/sound/named_sounds.h"
#include "samples/sandbox/sound/output.h"
#include "samples/sandbox/sound/wav_file.h"

namespace sandbox::sound {
namespace {

constexpr const char* kMaterials[] = {"glass",      "ice",  "wood",    "plastic",  "rubber", "metal",
                                      "hard metal", "rock", "plaster", "concrete", "brick",  "dirt"};
constexpr double kSizes[] = {0.2, 0.35, 0.5};

/// A mixer that is heard at the origin, and written to a file.
class Recorder {
public:
    Recorder(const std::string& path, std::string& error) {
        m_output = Output::openMemory(error);
        if (m_output) m_file = WavFile::create(path, 2, error);
    }
    Mixer& mixer() { return m_mixer; }
    void room(const Room& room) { m_output->setRoom(room); }
    void run(double seconds) {
        for (int i = 0; i < int(seconds * kSampleRate / kBlock + 0.5); ++i) {
            m_mixer.render();
            m_output->play(m_mixer.emitters(), {}, {0, 0, 0, 1});
            m_output->read(m_samples);
            m_file->write(m_samples);
            for (const float sample : m_samples) m_peak = std::max(m_peak, std::abs(sample));
        }
    }
    float peak() const { return m_peak; }

private:
    std::unique_ptr<Output> m_output;
    std::unique_ptr<WavFile> m_file;
    Mixer m_mixer;
    std::vector<float> m_samples;
    float m_peak = 0.0f;
};

Strike hitOn(const char* material, double size, double joules) {
    const size_t row = findAcousticMaterial(material);
    const AcousticMaterial& acoustic = acousticMaterials()[row];
    const double mass = 0.5, speed = std::sqrt(2.0 * joules / mass);
    const double contact = contactTime(acoustic, acousticMaterials()[findAcousticMaterial("rock")], mass, speed);
    return {{0, 0, -2}, row, bodySize(acoustic, {size, 0.8 * size, 0.1}, 0.1), joules, contact};
}

void hits(Recorder& recorder) {
    for (const char* material : kMaterials)
        for (const double size : kSizes) {
            recorder.mixer().add(hitOn(material, size, 20.0));
            recorder.run(1.0);
        }
}

/// A thousand hits a second of brick, concrete and wood, for three seconds, on a spot of ten metres.
void crash(Recorder& recorder) {
    Random random(7);
    const char* materials[] = {"brick", "concrete", "wood", "glass"};
    for (int step = 0; step < 180; ++step) {
        std::vector<Strike> strikes;
        for (int i = 0; i < 17; ++i) {
            Strike strike = hitOn(materials[random.bits() % 4], 0.1 + 0.6 * random.unit(), 5.0 * random.exponential());
            strike.position = {5.0 * random.sign(), random.unit(), -12.0 + 5.0 * random.sign()};
            strikes.push_back(strike);
        }
        for (const Strike& strike : joinStrikes(strikes, {}, 12)) recorder.mixer().add(strike);
        recorder.run(1.0 / 60.0);
    }
    recorder.run(1.5);
}

void loop(Recorder& recorder, std::string_view name) {
    Loop loop;
    loop.kind = findLoopKind(name);
    loop.position = {0, 0, -2};
    recorder.mixer().setLoops({loop});
    recorder.run(3.0);
    recorder.mixer().setLoops({});
    recorder.run(0.5);
}

void named(Recorder& recorder, std::string_view name) {
    for (const Strike& strike : soundStrikes(name, {0, 0, -4}, 1.0)) recorder.mixer().add(strike);
    recorder.run(3.0);
}

int run(const std::string& folder) {
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    std::string error;
    const auto record = [&](const std::string& name, const std::function<void(Recorder&)>& play) {
        if (!error.empty()) return;
        Recorder recorder(folder + "/" + name + ".wav", error);
        if (!error.empty()) return;
        recorder.room({8.0, 0.6});
        play(recorder);
        fmt::print("{:<12} peak {:.2f}\n", name, recorder.peak());
    };
    record("hits", hits);
    record("crash", crash);
    for (const std::string_view name : loopNames())
        record(std::string(name), [&](Recorder& recorder) { loop(recorder, name); });
    for (const std::string_view name : soundNames())
        record(std::string(name), [&](Recorder& recorder) { named(recorder, name); });
    if (!error.empty()) fmt::print(stderr, "sounds: {}\n", error);
    return error.empty() ? 0 : 1;
}

}  // namespace
}  // namespace sandbox::sound

int main(int argc, char** argv) {
    std::string folder = "out/sounds";
    CLI::App app{"Writes hits on twelve materials in three sizes, a crash, and each sound of the game as WAV files."};
    app.add_option("--out", folder, "folder of the files")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    return sandbox::sound::run(folder);
}
