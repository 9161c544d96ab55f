#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/texture.h"

namespace rubble {

/// A linked program. Its samplers get texture units, in the order in which the GL lists them, behind the one for
/// uploads.
class Program {
public:
    Program() = default;
    /// Takes over a linked program.
    explicit Program(GlName<ProgramKind> linked);
    /// From vertex and fragment source as the GL gets them. On failure the program is empty, `log` holds the GL's
    /// message and `vertexFailed` says which of the two it is about.
    Program(const std::string& vertexSource, const std::string& fragmentSource, std::string& log, bool& vertexFailed);

    explicit operator bool() const { return bool(m_name); }
    /// The GL's name of it; 0: empty.
    GLuint name() const { return m_name.get(); }
    /// Makes it the current program.
    void use() const { glUseProgram(name()); }

    /// Number of texture units that it uses.
    int samplers() const;

    /// Sets a uniform; one that the shader does not use is ignored. The program must be in use for all of these.
    void set(std::string_view uniform, int value) const;
    void set(std::string_view uniform, float value) const;             ///< the same
    void set(std::string_view uniform, glm::vec2 value) const;         ///< the same
    void set(std::string_view uniform, glm::vec3 value) const;         ///< the same
    void set(std::string_view uniform, glm::vec4 value) const;         ///< the same
    void set(std::string_view uniform, glm::ivec2 value) const;        ///< the same
    void set(std::string_view uniform, glm::ivec3 value) const;        ///< the same
    void set(std::string_view uniform, const glm::mat4& value) const;  ///< the same
    /// Sets the first elements of an array, whose name ends in [0].
    void set(std::string_view uniform, std::span<const glm::vec4> values) const;
    /// Binds a texture to the sampler's unit. In place of an empty one a placeholder of its kind is bound.
    void set(std::string_view sampler, const Texture& texture) const;
    /// Sets an array of lib/texels.glsl; the same for an empty one.
    void set(std::string_view array, const BufferTexture& texture) const;

private:
    struct Uniform {
        std::string name;
        GLint location;
        int unit;  ///< -1 if it is no sampler
    };
    const Uniform* find(std::string_view name) const;
    void bind(std::string_view sampler, GLenum target, GLuint texture) const;
    void listUniforms();

    GlName<ProgramKind> m_name;
    std::vector<Uniform> m_uniforms;
};

}  // namespace rubble
