#include "render/gl/program_build.h"

namespace rubble {
namespace {

std::string shaderLog(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(size_t(length), '\0');
    glGetShaderInfoLog(shader, length, &length, log.data());
    log.resize(size_t(length));
    return log;
}

std::string programLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(size_t(length), '\0');
    glGetProgramInfoLog(program, length, &length, log.data());
    log.resize(size_t(length));
    return log;
}

}  // namespace

ProgramBuild::ProgramBuild(const std::vector<Stage>& stages, ProgramCache* cache)
    : m_program(GlName<ProgramKind>::make()), m_cache(cache && cache->isOn() ? cache : nullptr) {
    if (m_cache) {
        for (const Stage& stage : stages) m_key = m_cache->keyOf(stage.source, m_key);
        m_isCached = m_cache->load(m_key, m_program.get());
        if (m_isCached) return;
        glProgramParameteri(m_program.get(), GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    }
    for (const Stage& stage : stages) {
        const GLuint shader = m_shaders.emplace_back(glCreateShader(stage.kind)).get();
        const char* text = stage.source.c_str();
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(m_program.get(), shader);
    }
    glLinkProgram(m_program.get());
}

Program ProgramBuild::finish(Failure& failure) {
    const auto shaders = std::move(m_shaders);
    GLint done = 0;
    glGetProgramiv(m_program.get(), GL_LINK_STATUS, &done);
    if (done) {
        for (const auto& shader : shaders) glDetachShader(m_program.get(), shader.get());
        if (m_cache && !m_isCached) m_cache->store(m_key, m_program.get());
        return Program(std::move(m_program));
    }
    const auto failed = std::exchange(m_program, {});
    for (size_t i = 0; i < shaders.size(); ++i) {
        glGetShaderiv(shaders[i].get(), GL_COMPILE_STATUS, &done);
        failure = {i, done ? programLog(failed.get()) : shaderLog(shaders[i].get())};
        if (!done) break;
    }
    return {};
}

}  // namespace rubble
