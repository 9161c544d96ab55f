#include "render/shader_library/built_program.h"

#include <algorithm>
#include <utility>

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

void BuiltProgram::start(const std::filesystem::path& folder, const ShaderBuild& how) {
    m_newest = newest(folder);
    m_error.clear();
    m_sources.clear();
    for (const std::string& file : {m_vertexFile, m_fragmentFile}) {
        if (file.empty()) continue;
        auto read = readShader(folder, file, how.defines);
        if (!read) {
            m_error = read.error();
            return;
        }
        m_sources.push_back(std::move(*read));
    }
    ShaderSource& fragment = m_sources.back();
    if (m_method) fragment = asFullscreen(std::move(fragment), m_kind, *m_method);
    if (m_method == FullscreenMethod::Fragment && how.varyingVectors > 0)
        passUniformsAsVaryings(m_sources.front(), fragment, how.varyingVectors);
    m_files.clear();
    for (const ShaderSource& source : m_sources)
        m_files.insert(m_files.end(), source.files.begin(), source.files.end());
    m_newest = newest(folder);
    std::vector<ProgramBuild::Stage> stages = {{GL_COMPUTE_SHADER, m_sources[0].text}};
    if (m_sources.size() == 2)
        stages = {{GL_VERTEX_SHADER, m_sources[0].text}, {GL_FRAGMENT_SHADER, m_sources[1].text}};
    m_build = ProgramBuild(stages, how.cache);
}

bool BuiltProgram::finish() {
    if (!m_build) return false;
    ProgramBuild::Failure failure;
    Program program = std::exchange(m_build, {}).finish(failure);
    const auto sources = std::exchange(m_sources, {});
    if (!program) {
        m_error = sources[failure.stage].explain(failure.log);
        return false;
    }
    m_program = std::move(program);
    return true;
}

std::filesystem::file_time_type BuiltProgram::newest(const std::filesystem::path& folder) const {
    auto newest = std::filesystem::file_time_type::min();
    if (folder.empty()) return newest;
    for (const std::string& file : m_files) {
        std::error_code missing;
        const auto time = std::filesystem::last_write_time(folder / file, missing);
        if (!missing) newest = std::max(newest, time);
    }
    return newest;
}

}  // namespace rubble
