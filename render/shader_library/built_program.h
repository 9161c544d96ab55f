#pragma once
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/gl/program_build.h"
#include "render/shader_library/fullscreen_source.h"

namespace rubble {

/// What the context asks of shader sources.
struct ShaderBuild {
    std::string defines;     ///< of all shaders: see readShader()
    int varyingVectors = 0;  ///< for full-screen fragment programs: see passUniformsAsVaryings(); 0: they read uniforms
    ProgramCache* cache = nullptr;  ///< of programs as the driver made them; null: none
};

/// A program, the files that it is built from, and the error in them, if they do not build as they are now.
class BuiltProgram {
public:
    /// A program of a fragment and a vertex shader, not built yet. Files are relative to the shader folder.
    BuiltProgram(std::string fragmentFile, std::string vertexFile);
    /// A full-screen program, not built yet.
    BuiltProgram(std::string fragmentFile, FullscreenKind kind, FullscreenMethod method);

    /// Starts to build it from what the files hold now; finish() must follow.
    void start(const std::filesystem::path& folder, const ShaderBuild& how = {});
    /// Waits for what start() began. False on an error: the last good program stays.
    bool finish();
    /// Whether a file is part of it, as far as it has been read.
    bool includes(const std::string& file) const { return std::count(m_files.begin(), m_files.end(), file) > 0; }
    /// Keeps its program for the next call, and takes back the one of the last call, which may be empty.
    void swapVariant() { std::swap(m_program, m_otherVariant); }
    /// Frees what swapVariant() would take back.
    void dropVariant() { m_otherVariant = {}; }
    /// Whether one of its files is newer than at the last build().
    bool hasChanged(const std::filesystem::path& folder) const { return newest(folder) > m_newest; }
    /// Whether it is the plain program of these two files.
    bool isOf(const std::string& fragmentFile, const std::string& vertexFile) const {
        return !m_method && m_fragmentFile == fragmentFile && m_vertexFile == vertexFile;
    }
    /// The last one that was built without an error; empty: none.
    const Program& program() const { return m_program; }
    /// What the last build() failed with, with file and line; empty: it did not fail.
    const std::string& error() const { return m_error; }

private:
    std::filesystem::file_time_type newest(const std::filesystem::path& folder) const;

    std::string m_fragmentFile, m_vertexFile;  ///< without a vertex file: a compute program
    FullscreenKind m_kind;
    std::optional<FullscreenMethod> m_method;  ///< none: a plain program
    std::vector<std::string> m_files;
    std::filesystem::file_time_type m_newest{};
    std::vector<ShaderSource> m_sources;  ///< from start() to finish(), by stage
    ProgramBuild m_build;                 ///< the same; empty: the files could not be read
    Program m_program, m_otherVariant;
    std::string m_error;
};

}  // namespace rubble
