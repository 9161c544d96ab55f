#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

#include "render/gl/name.h"

namespace rubble {

enum class Filter { Nearest, Linear };
enum class Wrap { Clamp, Repeat };

/// Bytes, format and type that go with a sized internal format. Asserts on one we do not use.
struct PixelFormat {
    GLenum format;
    GLenum type;
    int bytes;
};
PixelFormat pixelFormat(GLenum internalFormat);

/// A 2D texture of one level.
class Texture {
public:
    Texture() = default;
    Texture(GLenum internalFormat, glm::ivec2 size, Filter filter = Filter::Nearest, Wrap wrap = Wrap::Clamp);

    GLuint name() const { return m_name.get(); }
    GLenum target() const { return GL_TEXTURE_2D; }
    GLenum internalFormat() const { return m_internalFormat; }
    glm::ivec2 size() const { return m_size; }
    uint64_t bytes() const { return uint64_t(m_size.x) * m_size.y * pixelFormat(m_internalFormat).bytes; }
    explicit operator bool() const { return bool(m_name); }

    /// Rows from the bottom up, tightly packed, in pixelFormat() of the internal format.
    void upload(const void* pixels);
    void uploadRows(int firstRow, int rows, const void* pixels);

private:
    GlName<TextureKind> m_name;
    GLenum m_internalFormat = 0;
    glm::ivec2 m_size{0};
};

/// A buffer that shaders read with texelFetch(samplerBuffer). Grows by doubling; what it held stays.
class BufferTexture {
public:
    BufferTexture() = default;
    explicit BufferTexture(GLenum internalFormat);

    GLuint name() const { return m_texture.get(); }
    GLenum target() const { return GL_TEXTURE_BUFFER; }
    uint64_t bytes() const { return m_capacity; }
    /// Makes room for this many bytes. False if the GL's largest buffer texture is smaller.
    bool reserve(uint64_t bytes);
    void upload(uint64_t offset, std::span<const std::byte> data);

private:
    GlName<TextureKind> m_texture;
    GlName<BufferKind> m_buffer;
    GLenum m_internalFormat = 0;
    uint64_t m_capacity = 0;
};

}  // namespace rubble
