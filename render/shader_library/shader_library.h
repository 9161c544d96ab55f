#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/gl/program.h"

namespace rubble {

/// Every program of the renderer, built from the files of shaders/. A program that fails is empty (its pass is skipped)
/// and its error, with file and line, is in errors(). [render-thread]
class ShaderLibrary {
public:
    explicit ShaderLibrary(std::filesystem::path folder) : m_folder(std::move(folder)) {}

    /// Files under the shader folder. The reference stays valid; a reload puts a new program into it.
    const Program& load(const std::string& fragmentFile, const std::string& vertexFile = "lib/fullscreen.vert");
    /// Rebuilds what uses a file that changed on disk; on an error the last good program stays. True if any was rebuilt.
    bool reloadChanged();
    /// Of the programs whose files do not build as they are now, with file and line.
    std::vector<std::string> errors() const;

private:
    struct Entry {
        std::string vertexFile, fragmentFile;
        std::vector<std::string> files;
        std::filesystem::file_time_type newest;
        Program program;
        std::string error = {};
    };
    bool build(Entry& entry);
    std::filesystem::file_time_type newestOf(const std::vector<std::string>& files) const;

    std::filesystem::path m_folder;
    std::vector<std::unique_ptr<Entry>> m_entries;
};

}  // namespace rubble
