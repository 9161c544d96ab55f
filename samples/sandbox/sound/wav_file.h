#pragma once
#include <memory>
#include <span>
#include <string>

namespace sandbox::sound {

/// A WAV file of 24 bits that is written.
class WavFile {
public:
    /// Null, and what is wrong, if it cannot be written.
    static std::unique_ptr<WavFile> create(const std::string& path, int channels, std::string& error);
    ~WavFile();
    WavFile(const WavFile&) = delete;
    WavFile& operator=(const WavFile&) = delete;
    /// Adds samples of all channels, -1 to 1; what is beyond is cut off. False: it could not be written.
    bool write(std::span<const float> samples);

private:
    struct File;
    explicit WavFile(std::unique_ptr<File> file);
    std::unique_ptr<File> m_file;
};

}  // namespace sandbox::sound
