#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

namespace rubble {

/// A path in a folder of this process, which is removed at its end. It lies in memory where the machine has such a
/// folder.
inline std::string scratchPath(const char* name) {
    namespace fs = std::filesystem;
    class Folder {
    public:
        Folder() {
            std::error_code code;
            const fs::path parent = fs::is_directory("/dev/shm", code) ? "/dev/shm" : fs::temp_directory_path();
            m_path = parent / ("rubble_fuzz_" + std::to_string(getpid()));
            fs::create_directories(m_path);
        }
        ~Folder() {
            std::error_code ignored;
            fs::remove_all(m_path, ignored);
        }
        const fs::path& path() const { return m_path; }

    private:
        fs::path m_path;
    };
    static const Folder folder;
    return (folder.path() / name).string();
}

}  // namespace rubble
