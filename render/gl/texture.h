#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string_view>

#include "render/gl/shared_texels.h"

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

/// Binds a texture to the unit for uploads, so that those of the program in use keep theirs.
void bindForUpload(GLenum target, GLuint texture);
/// Whether the GL had memory for level 0 of the texture that bindForUpload() has bound last. If not, the GL's error is
/// taken from its queue.
bool wasAllocated(GLenum target);

/// A 2D texture of one level.
class Texture {
public:
    Texture() = default;
    /// size: pixels. What it holds is undefined.
    Texture(GLenum internalFormat, glm::ivec2 size, Filter filter = Filter::Nearest, Wrap wrap = Wrap::Clamp);
    /// What stands for a texture that there is not: Program::set() binds a placeholder of its kind.
    static Texture none(GLenum internalFormat, glm::ivec2 size, Filter filter = Filter::Nearest,
                        Wrap wrap = Wrap::Clamp);

    /// The GL's name of it; 0: none.
    GLuint name() const { return m_name.get(); }
    /// The GL's kind of texture.
    GLenum target() const { return GL_TEXTURE_2D; }
    /// As given to the constructor.
    GLenum internalFormat() const { return m_internalFormat; }
    Filter filter() const { return m_filter; }  ///< the same
    Wrap wrap() const { return m_wrap; }        ///< the same
    /// In pixels.
    glm::ivec2 size() const { return m_size; }
    /// GPU memory.
    uint64_t bytes() const { return !m_name ? 0 : uint64_t(m_size.x) * m_size.y * pixelFormat(m_internalFormat).bytes; }
    explicit operator bool() const { return bool(m_name); }
    /// Whether the GL had memory for it.
    bool isAllocated() const { return m_isAllocated; }

    /// Replaces all of it. Rows from the bottom up, tightly packed, in pixelFormat() of the internal format.
    void upload(const void* pixels);

private:
    GlName<TextureKind> m_name;
    GLenum m_internalFormat = 0;
    glm::ivec2 m_size{0};
    Filter m_filter = Filter::Nearest;
    Wrap m_wrap = Wrap::Clamp;
    bool m_isAllocated = false;
};

/// An array of texels that shaders read by index (lib/texels.glsl): a buffer texture, or a part of the shared texture
/// of its format, where the TexelStore in use when it is first filled says so. When it grows it keeps what it holds.
class BufferTexture {
public:
    BufferTexture() = default;
    /// internalFormat: of a texel. The GL is not called before reserve().
    explicit BufferTexture(GLenum internalFormat) : m_internalFormat(internalFormat) {}
    BufferTexture(BufferTexture&& other) noexcept = default;
    BufferTexture& operator=(BufferTexture&& other) noexcept;
    ~BufferTexture() { release(); }

    /// The GL's name of the texture; 0: nothing was reserved.
    GLuint name() const { return m_shared ? m_shared->name() : m_texture.get(); }
    /// As given to the constructor.
    GLenum internalFormat() const { return m_internalFormat; }
    /// The GL's kind of texture.
    GLenum target() const { return m_shared ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_BUFFER; }
    /// The sampler that it is read through, where it is a part of a shared texture; empty where it has its own.
    std::string_view sharedSampler() const;
    /// Where it is a part of a shared texture: the number of its first texel there.
    int firstTexel() const { return m_shared ? int(m_rows.first << m_shared->sideBits()) : 0; }
    /// Its capacity.
    uint64_t bytes() const { return m_capacity; }
    /// Makes its capacity at least this. False if the GL has no room: then it is as before.
    bool reserve(uint64_t bytes);
    /// Replaces a part of it. Offset in bytes, within the capacity; whole texels.
    void upload(uint64_t offset, std::span<const std::byte> data);
    /// Replaces all of it, without waiting for draws that still read what it held. False if the GL has no room: then
    /// it is as before.
    bool refill(std::span<const std::byte> data);

private:
    bool reserveOwn(uint64_t bytes);
    bool reserveShared(uint64_t bytes);
    void release();

    GlName<TextureKind> m_texture;
    GlName<BufferKind> m_buffer;
    std::shared_ptr<SharedTexels> m_shared;
    SharedTexels::Rows m_rows;  ///< in m_shared
    GLenum m_internalFormat = 0;
    uint64_t m_capacity = 0;
};

}  // namespace rubble
