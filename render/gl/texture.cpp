#include "render/gl/texture.h"

#include <algorithm>
#include <bit>

#include "runtime/core/assertion.h"

namespace rubble {
namespace {

constexpr uint64_t kStep = 4096;  ///< bytes by which buffers grow
/// Bytes in a buffer beside its steps: for llvmpipe buffers whose size is a power of two, or a multiple of 64 KiB, are
/// of another kind, for which it builds a program again.
constexpr uint64_t kBeside = 256;

/// Capacity for `bytes`: many small growths must not copy the buffer each time.
uint64_t grown(uint64_t capacity, uint64_t bytes) {
    return (std::max(bytes, capacity + capacity / 16) + kStep - 1) / kStep * kStep + kBeside;
}

/// Gives the buffer that is bound to COPY_WRITE a new store. False if the GL has no memory for it.
bool allocateBuffer(uint64_t bytes, GLenum usage) {
    glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(bytes), nullptr, usage);
    GLint64 found = 0;
    glGetBufferParameteri64v(GL_COPY_WRITE_BUFFER, GL_BUFFER_SIZE, &found);
    if (uint64_t(found) == bytes) return true;
    glGetError();
    return false;
}

}  // namespace

void bindForUpload(GLenum target, GLuint texture) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(target, texture);
}

bool wasAllocated(GLenum target) {
    GLint width = 0;
    glGetTexLevelParameteriv(target, 0, GL_TEXTURE_WIDTH, &width);
    if (width > 0) return true;
    glGetError();
    return false;
}

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
    RUBBLE_ASSERT(false && "a texture format that pixelFormat() does not list");
    return {};
}

Texture::Texture(GLenum internalFormat, glm::ivec2 size, Filter filter, Wrap wrap)
    : m_name(GlName<TextureKind>::make()),
      m_internalFormat(internalFormat),
      m_size(size),
      m_filter(filter),
      m_wrap(wrap) {
    const PixelFormat pixel = pixelFormat(internalFormat);
    bindForUpload(GL_TEXTURE_2D, name());
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(internalFormat), size.x, size.y, 0, pixel.format, pixel.type, nullptr);
    m_isAllocated = wasAllocated(GL_TEXTURE_2D);
    const GLint filterGl = filter == Filter::Linear ? GL_LINEAR : GL_NEAREST;
    const GLint wrapGl = wrap == Wrap::Repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filterGl);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filterGl);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapGl);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapGl);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

Texture Texture::none(GLenum internalFormat, glm::ivec2 size, Filter filter, Wrap wrap) {
    Texture texture;
    texture.m_internalFormat = internalFormat;
    texture.m_size = size;
    texture.m_filter = filter;
    texture.m_wrap = wrap;
    return texture;
}

void Texture::upload(const void* pixels) {
    const PixelFormat pixel = pixelFormat(m_internalFormat);
    bindForUpload(GL_TEXTURE_2D, name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, m_size.x, m_size.y, pixel.format, pixel.type, pixels);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

BufferTexture& BufferTexture::operator=(BufferTexture&& other) noexcept {
    std::swap(m_texture, other.m_texture);
    std::swap(m_buffer, other.m_buffer);
    std::swap(m_shared, other.m_shared);
    std::swap(m_rows, other.m_rows);
    std::swap(m_internalFormat, other.m_internalFormat);
    std::swap(m_capacity, other.m_capacity);
    return *this;
}

void BufferTexture::release() {
    if (m_shared) m_shared->free(m_rows);
}

std::string_view BufferTexture::sharedSampler() const {
    if (!m_shared) return {};
    return m_shared->texelBytes() == 4 ? "uTexels1" : m_shared->texelBytes() == 8 ? "uTexels2" : "uTexels4";
}

bool BufferTexture::reserve(uint64_t bytes) {
    if (bytes <= m_capacity) return true;
    if (!m_capacity && TexelStore::current()) m_shared = TexelStore::current()->of(m_internalFormat);
    return m_shared ? reserveShared(bytes) : reserveOwn(bytes);
}

bool BufferTexture::reserveShared(uint64_t bytes) {
    const uint64_t rowBytes = uint64_t(m_shared->rowTexels()) * m_shared->texelBytes();
    const auto rowsFor = [&](uint64_t size) { return uint32_t((size + rowBytes - 1) / rowBytes); };
    if (!m_shared->grow(m_rows, rowsFor(grown(m_capacity, bytes))) && !m_shared->grow(m_rows, rowsFor(bytes)))
        return false;
    m_capacity = m_rows.count * rowBytes;
    return true;
}

bool BufferTexture::reserveOwn(uint64_t bytes) {
    const TexelStore* store = TexelStore::current();
    const GlLimits limits = store ? store->limits() : GlLimits::ofContext();
    const uint64_t most = uint64_t(limits.bufferTexels) * uint64_t(pixelFormat(m_internalFormat).bytes);
    if (bytes > most) return false;
    const uint64_t capacity = std::min(most, grown(m_capacity, bytes));
    auto buffer = GlName<BufferKind>::make();
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.get());
    const bool hasRoom = allocateBuffer(capacity, GL_DYNAMIC_DRAW);
    if (hasRoom && m_buffer) {
        glBindBuffer(GL_COPY_READ_BUFFER, m_buffer.get());
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, GLsizeiptr(m_capacity));
        glBindBuffer(GL_COPY_READ_BUFFER, 0);
    }
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    if (!hasRoom) return false;
    if (!m_texture) m_texture = GlName<TextureKind>::make();
    bindForUpload(GL_TEXTURE_BUFFER, m_texture.get());
    glTexBuffer(GL_TEXTURE_BUFFER, m_internalFormat, buffer.get());
    m_buffer = std::move(buffer);
    m_capacity = capacity;
    return true;
}

void BufferTexture::upload(uint64_t offset, std::span<const std::byte> data) {
    RUBBLE_ASSERT(offset + data.size() <= m_capacity && "an upload past the capacity: call reserve() before");
    if (m_shared) return m_shared->upload(m_rows, offset / m_shared->texelBytes(), data);
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer.get());
    glBufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(offset), GLsizeiptr(data.size()), data.data());
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

bool BufferTexture::refill(std::span<const std::byte> data) {
    if (data.empty()) return true;
    if (!reserve(data.size())) return false;
    if (!m_shared) {  // a new store for the buffer: the GL keeps the old one until it is no longer read
        glBindBuffer(GL_COPY_WRITE_BUFFER, m_buffer.get());
        glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(m_capacity), nullptr, GL_STREAM_DRAW);
    }
    upload(0, data);
    return true;
}

}  // namespace rubble
