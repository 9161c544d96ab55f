#include "render/shader_library/built_program.h"

#include <algorithm>

#include "render/shader_library/uniforms_as_varyings.h"

namespace rubble {

BuiltProgram::BuiltProgram(std::string fragmentFile, std::string vertexFile)
    : m_fragmentFile(std::move(fragmentFile)),
      m_vertexFile(std::move(vertexFile)),
      m_files{m_vertexFile, m_fragmentFile} {}

BuiltProgram::BuiltProgram(std::string fragmentFile, FullscreenKind kind, FullscreenMethod method)
    : BuiltProgram(std::move(fragmentFile), method == FullscreenMethod::Fragment ? kind.vertexFile : "") {
    m_kind = std::move(kind);
    m_method = method;
}

bool BuiltProgram::build(const std::filesystem::path& folder, const ShaderBuild& how) {
    m_newest = newest(folder);
    const auto vertex = m_vertexFile.empty() ? Result<ShaderSource>(ShaderSource()) : readShader(folder, m_vertexFile);
    const auto read = readShader(folder, m_fragmentFile, how.defines);
    if (!vertex || !read) {
        m_error = vertex ? read.error() : vertex.error();
        return false;
    }
    ShaderSource source = m_method ? asFullscreen(*read, m_kind, *m_method) : *read, vertexSource = *vertex;
    if (m_method == FullscreenMethod::Fragment && how.uniformsAsVaryings) passUniformsAsVaryings(vertexSource, source);
    m_files = vertex->files;
    m_files.insert(m_files.end(), source.files.begin(), source.files.end());
    m_newest = newest(folder);
    std::string log;
    bool vertexFailed = false;
    Program program =
        m_vertexFile.empty() ? Program(source.text, log) : Program(vertexSource.text, source.text, log, vertexFailed);
    if (!program) {
        m_error = (vertexFailed ? vertexSource : source).explain(log);
        return false;
    }
    m_error.clear();
    m_program = std::move(program);
    return true;
}

std::filesystem::file_time_type BuiltProgram::newest(const std::filesystem::path& folder) const {
    auto newest = std::filesystem::file_time_type::min();
    for (const std::string& file : m_files) {
        std::error_code missing;
        const auto time = std::filesystem::last_write_time(folder / file, missing);
        if (!missing) newest = std::max(newest, time);
    }
    return newest;
}

}  // namespace rubble
