#include "render/gl/program.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "render/gl/placeholders.h"
#include "render/gl/program_build.h"
#include "runtime/core/assertion.h"

namespace rubble {
namespace {

bool isSampler(GLenum type) {
    switch (type) {
        case GL_SAMPLER_2D:
        case GL_SAMPLER_3D:
        case GL_SAMPLER_BUFFER:
        case GL_INT_SAMPLER_2D:
        case GL_INT_SAMPLER_BUFFER:
        case GL_UNSIGNED_INT_SAMPLER_2D:
        case GL_UNSIGNED_INT_SAMPLER_2D_ARRAY:
        case GL_UNSIGNED_INT_SAMPLER_3D:
        case GL_UNSIGNED_INT_SAMPLER_BUFFER:
            return true;
    }
    return false;
}

}  // namespace

Program::Program(GlName<ProgramKind> linked) : m_name(std::move(linked)) {
    listUniforms();
}

Program::Program(const std::string& vertexSource, const std::string& fragmentSource, std::string& log,
                 bool& vertexFailed) {
    ProgramBuild build({{GL_VERTEX_SHADER, vertexSource}, {GL_FRAGMENT_SHADER, fragmentSource}}, nullptr);
    ProgramBuild::Failure failure;
    *this = build.finish(failure);
    log = failure.log;
    vertexFailed = !*this && failure.stage == 0;
}

void Program::listUniforms() {
    use();
    GLint count = 0;
    glGetProgramiv(name(), GL_ACTIVE_UNIFORMS, &count);
    int units = 1;
    for (GLint i = 0; i < count; ++i) {
        char text[128];
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(name(), GLuint(i), sizeof text, &length, &size, &type, text);
        const GLint location = glGetUniformLocation(name(), text);
        if (location < 0) continue;  // a member of a uniform block
        int unit = -1;
        if (isSampler(type)) {
            unit = units++;
            glUniform1i(location, unit);
        }
        m_uniforms.push_back({text, location, unit});
    }
    RUBBLE_ASSERT(units <= kTextureUnits && "a program with more samplers than there are units for them");
    const GLuint block = glGetUniformBlockIndex(name(), "FrameBlock");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(name(), block, 0);
    glUseProgram(0);
}

int Program::samplers() const {
    return int(std::count_if(m_uniforms.begin(), m_uniforms.end(), [](const Uniform& u) { return u.unit >= 0; }));
}

const Program::Uniform* Program::find(std::string_view name) const {
    for (const Uniform& uniform : m_uniforms)
        if (uniform.name == name) return &uniform;
    return nullptr;
}

void Program::set(std::string_view name, int value) const {
    if (const Uniform* u = find(name)) glUniform1i(u->location, value);
}
void Program::set(std::string_view name, float value) const {
    if (const Uniform* u = find(name)) glUniform1f(u->location, value);
}
void Program::set(std::string_view name, glm::vec2 value) const {
    if (const Uniform* u = find(name)) glUniform2fv(u->location, 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, glm::vec3 value) const {
    if (const Uniform* u = find(name)) glUniform3fv(u->location, 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, glm::vec4 value) const {
    if (const Uniform* u = find(name)) glUniform4fv(u->location, 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, glm::ivec2 value) const {
    if (const Uniform* u = find(name)) glUniform2iv(u->location, 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, glm::ivec3 value) const {
    if (const Uniform* u = find(name)) glUniform3iv(u->location, 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::mat4& value) const {
    if (const Uniform* u = find(name)) glUniformMatrix4fv(u->location, 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(std::string_view name, std::span<const glm::vec4> values) const {
    if (const Uniform* u = find(name)) glUniform4fv(u->location, GLsizei(values.size()), glm::value_ptr(values[0]));
}

void Program::set(std::string_view sampler, const Texture& given) const {
    TexelStore* store = TexelStore::current();
    const Texture& texture = store ? store->placeholders().orOfItsKind(given) : given;
    bind(sampler, texture.target(), texture.name());
}

void Program::set(std::string_view array, const BufferTexture& given) const {
    TexelStore* store = TexelStore::current();
    const BufferTexture& texture = store ? store->placeholders().orOfItsKind(given) : given;
    const std::string_view shared = texture.sharedSampler();
    bind(shared.empty() ? array : shared, texture.target(), texture.name());
    if (!shared.empty()) set(array, texture.firstTexel());
}

void Program::bind(std::string_view sampler, GLenum target, GLuint texture) const {
    const Uniform* u = find(sampler);
    if (!u || u->unit < 0) return;
    glActiveTexture(GLenum(GL_TEXTURE0 + u->unit));
    glBindTexture(target, texture);
}

}  // namespace rubble
