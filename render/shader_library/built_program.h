#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/gl/program.h"
#include "render/shader_library/fullscreen_source.h"

namespace rubble {

/// How a GL wants its shaders.
struct ShaderBuild {
    std::string defines;              ///< see readShader()
    bool uniformsAsVaryings = false;  ///< full-screen fragment programs: see passUniformsAsVaryings()
};

/// A program, the files that it is built from, and what is wrong with them as they are now.
class BuiltProgram {
public:
    /// Nothing is built yet.
    BuiltProgram(std::string fragmentFile, std::string vertexFile);
    /// Of a shader that covers its targets.
    BuiltProgram(std::string fragmentFile, FullscreenKind kind, FullscreenMethod by);

    /// From what the files hold now. False on an error; the last good program stays.
    bool build(const std::filesystem::path& folder, const ShaderBuild& how = {});
    bool hasChanged(const std::filesystem::path& folder) const { return newest(folder) > m_newest; }
    bool isOf(const std::string& fragmentFile, const std::string& vertexFile) const {
        return !m_by && m_fragmentFile == fragmentFile && m_vertexFile == vertexFile;
    }
    const Program& program() const { return m_program; }
    /// With file and line; empty: none.
    const std::string& error() const { return m_error; }

private:
    std::filesystem::file_time_type newest(const std::filesystem::path& folder) const;

    std::string m_fragmentFile, m_vertexFile;  ///< no vertex file: a compute program
    FullscreenKind m_kind;
    std::optional<FullscreenMethod> m_by;  ///< none: a plain program
    std::vector<std::string> m_files;
    std::filesystem::file_time_type m_newest{};
    Program m_program;
    std::string m_error;
};

}  // namespace rubble
