#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/texture.h"

namespace rubble {

/// A linked program. Its samplers get texture units when it is linked, in the order the GL lists them.
/// Setting a uniform that the shader does not use is ignored.
class Program {
public:
    Program() = default;
    /// Vertex and fragment source as the GL gets them. On failure `log` holds the GL's words and the program is empty.
    Program(const std::string& vertexSource, const std::string& fragmentSource, std::string& log, bool& vertexFailed);
    /// A compute program, where hasCompute().
    Program(const std::string& computeSource, std::string& log);

    explicit operator bool() const { return bool(m_name); }
    GLuint name() const { return m_name.get(); }
    void use() const { glUseProgram(name()); }

    int samplers() const;  ///< texture units that it takes

    // The program must be in use.
    void set(std::string_view uniform, int value) const;
    void set(std::string_view uniform, float value) const;
    void set(std::string_view uniform, glm::vec2 value) const;
    void set(std::string_view uniform, glm::vec3 value) const;
    void set(std::string_view uniform, glm::vec4 value) const;
    void set(std::string_view uniform, glm::ivec2 value) const;
    void set(std::string_view uniform, glm::ivec3 value) const;
    void set(std::string_view uniform, const glm::mat4& value) const;
    /// The first elements of an array; its name ends in [0].
    void set(std::string_view uniform, std::span<const glm::vec4> values) const;
    /// Binds a texture to the sampler's unit.
    void set(std::string_view sampler, const Texture& texture) const {
        bind(sampler, texture.target(), texture.name());
    }
    void set(std::string_view sampler, const BufferTexture& texture) const {
        bind(sampler, texture.target(), texture.name());
    }

private:
    struct Uniform {
        std::string name;
        GLint location;
        int unit;  ///< -1 if it is no sampler
    };
    const Uniform* find(std::string_view name) const;
    void bind(std::string_view sampler, GLenum target, GLuint texture) const;
    void link(std::initializer_list<GLuint> shaders, std::string& log);
    void listUniforms();

    GlName<ProgramKind> m_name;
    std::vector<Uniform> m_uniforms;
};

}  // namespace rubble
