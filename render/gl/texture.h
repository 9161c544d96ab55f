#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

#include "render/gl/name.h"

namespace rubble {

enum class Filter { Nearest, Linear };
enum class Wrap { Clamp, Repeat };

/// Format, type and bytes of the pixels that go with a sized internal format.
struct PixelFormat {
    GLenum format;
    GLenum type;
    int bytes;
};
/// Asserts on an internal format that the renderer does not use.
PixelFormat pixelFormat(GLenum internalFormat);

/// A 2D texture of one level.
class Texture {
public:
    Texture() = default;
    /// size: pixels. What it holds is undefined.
    Texture(GLenum internalFormat, glm::ivec2 size, Filter filter = Filter::Nearest, Wrap wrap = Wrap::Clamp);

    /// The GL's name of it; 0: none.
    GLuint name() const { return m_name.get(); }
    /// The GL's kind of texture.
    GLenum target() const { return GL_TEXTURE_2D; }
    /// As given to the constructor.
    GLenum internalFormat() const { return m_internalFormat; }
    /// In pixels.
    glm::ivec2 size() const { return m_size; }
    /// GPU memory.
    uint64_t bytes() const { return uint64_t(m_size.x) * m_size.y * pixelFormat(m_internalFormat).bytes; }
    explicit operator bool() const { return bool(m_name); }

    /// Replaces all of it. Rows from the bottom up, tightly packed, in pixelFormat() of the internal format.
    void upload(const void* pixels);

private:
    GlName<TextureKind> m_name;
    GLenum m_internalFormat = 0;
    glm::ivec2 m_size{0};
};

/// A buffer that shaders read with texelFetch(samplerBuffer). When it grows it keeps what it holds.
class BufferTexture {
public:
    BufferTexture() = default;
    /// internalFormat: of a texel.
    explicit BufferTexture(GLenum internalFormat);

    /// The GL's name of the texture.
    GLuint name() const { return m_texture.get(); }
    /// The GL's kind of texture.
    GLenum target() const { return GL_TEXTURE_BUFFER; }
    /// Its capacity.
    uint64_t bytes() const { return m_capacity; }
    /// Makes its capacity at least this. False if the GL's largest buffer texture is smaller.
    bool reserve(uint64_t bytes);
    /// Replaces a part of it. Offset in bytes, within the capacity.
    void upload(uint64_t offset, std::span<const std::byte> data);

private:
    GlName<TextureKind> m_texture;
    GlName<BufferKind> m_buffer;
    GLenum m_internalFormat = 0;
    uint64_t m_capacity = 0;
};

}  // namespace rubble
