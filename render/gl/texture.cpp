#include "render/gl/texture.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace rubble {
namespace {

/// Binds a texture to the last unit that GlStateGuard restores, so that the units of the program in use keep theirs.
void bindForUpload(GLenum target, GLuint texture) {
    glActiveTexture(GLenum(GL_TEXTURE0 + kTextureUnits - 1));
    glBindTexture(target, texture);
}

}  // namespace

PixelFormat pixelFormat(GLenum internalFormat) {
    switch (internalFormat) {
        case GL_R8:
            return {GL_RED, GL_UNSIGNED_BYTE, 1};
        case GL_RG8:
            return {GL_RG, GL_UNSIGNED_BYTE, 2};
        case GL_RGBA8:
            return {GL_RGBA, GL_UNSIGNED_BYTE, 4};
        case GL_RG16F:
            return {GL_RG, GL_HALF_FLOAT, 4};
        case GL_RGBA16F:
            return {GL_RGBA, GL_HALF_FLOAT, 8};
        case GL_R32F:
            return {GL_RED, GL_FLOAT, 4};
        case GL_RGBA32F:
            return {GL_RGBA, GL_FLOAT, 16};
        case GL_R8UI:
            return {GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1};
        case GL_R32UI:
            return {GL_RED_INTEGER, GL_UNSIGNED_INT, 4};
        case GL_RG32UI:
            return {GL_RG_INTEGER, GL_UNSIGNED_INT, 8};
        case GL_RGBA32UI:
            return {GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16};
        case GL_RGBA32I:
            return {GL_RGBA_INTEGER, GL_INT, 16};
        case GL_DEPTH_COMPONENT32F:
            return {GL_DEPTH_COMPONENT, GL_FLOAT, 4};
    }
    assert(false && "a texture format that pixelFormat() does not list");
    return {};
}

Texture::Texture(GLenum internalFormat, glm::ivec2 size, Filter filter, Wrap wrap)
    : m_name(GlName<TextureKind>::make()), m_internalFormat(internalFormat), m_size(size) {
    const PixelFormat pixel = pixelFormat(internalFormat);
    bindForUpload(GL_TEXTURE_2D, name());
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(internalFormat), size.x, size.y, 0, pixel.format, pixel.type, nullptr);
    const GLint filterGl = filter == Filter::Linear ? GL_LINEAR : GL_NEAREST;
    const GLint wrapGl = wrap == Wrap::Repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filterGl);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filterGl);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapGl);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapGl);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void Texture::upload(const void* pixels) {
    const PixelFormat pixel = pixelFormat(m_internalFormat);
    bindForUpload(GL_TEXTURE_2D, name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, m_size.x, m_size.y, pixel.format, pixel.type, pixels);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

BufferTexture::BufferTexture(GLenum internalFormat)
    : m_texture(GlName<TextureKind>::make()), m_internalFormat(internalFormat) {
    reserve(4096);
}

bool BufferTexture::reserve(uint64_t bytes) {
    if (bytes <= m_capacity) return true;
    GLint maxTexels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &maxTexels);
    const uint64_t most = uint64_t(maxTexels) * pixelFormat(m_internalFormat).bytes;
    if (bytes > most) return false;
    constexpr uint64_t kStep = 4096;
    const uint64_t grown =
        std::max(bytes, m_capacity + m_capacity / 16);  // many small growths must not copy the buffer each time
    const uint64_t capacity = std::min(most, (grown + kStep - 1) / kStep * kStep);

    auto buffer = GlName<BufferKind>::make();
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.get());
    glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(capacity), nullptr, GL_DYNAMIC_DRAW);
    if (m_buffer) {
        glBindBuffer(GL_COPY_READ_BUFFER, m_buffer.get());
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, GLsizeiptr(m_capacity));
        glBindBuffer(GL_COPY_READ_BUFFER, 0);
    }
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    bindForUpload(GL_TEXTURE_BUFFER, m_texture.get());
    glTexBuffer(GL_TEXTURE_BUFFER, m_internalFormat, buffer.get());
    m_buffer = std::move(buffer);
    m_capacity = capacity;
    return true;
}

void BufferTexture::upload(uint64_t offset, std::span<const std::byte> data) {
    assert(offset + data.size() <= m_capacity && "an upload past the capacity: call reserve() before");
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer.get());
    glBufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(offset), GLsizeiptr(data.size()), data.data());
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

}  // namespace rubble
