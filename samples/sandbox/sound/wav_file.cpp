#include "samples/sandbox/sound/wav_file.h"

#include <sndfile.h>

#include <utility>

#include "samples/sandbox/sound/resonators.h"

namespace sandbox::sound {

struct WavFile::File {
    SNDFILE* handle = nullptr;
    ~File() { sf_close(handle); }
};

WavFile::WavFile(std::unique_ptr<File> file) : m_file(std::move(file)) {}
WavFile::~WavFile() = default;

std::unique_ptr<WavFile> WavFile::create(const std::string& path, int channels, std::string& error) {
    SF_INFO info = {};
    info.samplerate = kSampleRate;
    info.channels = channels;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_24;
    SNDFILE* handle = sf_open(path.c_str(), SFM_WRITE, &info);
    if (!handle) return error = path + ": " + sf_strerror(nullptr), nullptr;
    sf_command(handle, SFC_SET_CLIPPING, nullptr, SF_TRUE);
    auto file = std::make_unique<File>();
    file->handle = handle;
    return std::unique_ptr<WavFile>(new WavFile(std::move(file)));
}

bool WavFile::write(std::span<const float> samples) {
    return sf_write_float(m_file->handle, samples.data(), sf_count_t(samples.size())) == sf_count_t(samples.size());
}

}  // namespace sandbox::sound
