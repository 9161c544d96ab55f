#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

namespace rubble {

/// A folder of this process and this object alone: empty at first, removed with its content at the end.
class TempFolder {
public:
    /// Creates the folder. Not safe to call from several threads at once.
    TempFolder() {
        static int count = 0;
        m_path = std::filesystem::temp_directory_path() /
                 ("rubble_test_" + std::to_string(getpid()) + "_" + std::to_string(++count));
        std::filesystem::remove_all(m_path);
        std::filesystem::create_directories(m_path);
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    /// An absolute path, without a slash at its end.
    const std::filesystem::path& path() const { return m_path; }
    std::string operator/(const std::string& file) const { return (m_path / file).string(); }

private:
    std::filesystem::path m_path;
};

}  // namespace rubble
