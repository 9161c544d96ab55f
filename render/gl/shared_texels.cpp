#include "render/gl/shared_texels.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "render/gl/placeholders.h"
#include "render/gl/texture.h"
#include "runtime/core/assertion.h"

namespace rubble {
namespace {

constexpr int kMaxSideBits = 10;                     ///< GL 3.3 promises layers of 1024 x 1024
constexpr int64_t kEnoughTexels = int64_t(1) << 25;  ///< of a buffer texture, for each array to have one

thread_local TexelStore* g_current = nullptr;

}  // namespace

int SharedTexels::sideBits(const GlLimits& limits) {
    return std::min(kMaxSideBits, int(std::bit_width(unsigned(limits.textureSide))) - 1);
}

SharedTexels::SharedTexels(GLenum internalFormat, const GlLimits& limits)
    : m_internalFormat(internalFormat),
      m_texelBytes(uint32_t(pixelFormat(internalFormat).bytes)),
      m_sideBits(sideBits(limits)),
      m_maxLayers(limits.arrayLayers) {}

GlName<TextureKind> SharedTexels::makeTexture(int rows, int layers) const {
    auto texture = GlName<TextureKind>::make();
    bindForUpload(GL_TEXTURE_2D_ARRAY, texture.get());
    const PixelFormat pixel = pixelFormat(m_internalFormat);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GLint(m_internalFormat), GLsizei(rowTexels()), rows, layers, 0, pixel.format,
                 pixel.type, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D_ARRAY, filter, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    return wasAllocated(GL_TEXTURE_2D_ARRAY) ? std::move(texture) : GlName<TextureKind>();
}

void SharedTexels::copy(GLuint from, glm::ivec2 rowAndLayer, GLuint to, glm::ivec2 toRowAndLayer, int rows) {
    if (!m_reader) m_reader = GlName<FramebufferKind>::make();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_reader.get());
    glFramebufferTextureLayer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, from, 0, rowAndLayer.y);
    bindForUpload(GL_TEXTURE_2D_ARRAY, to);
    glCopyTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, toRowAndLayer.x, toRowAndLayer.y, 0, rowAndLayer.x,
                        GLsizei(rowTexels()), rows);
    glFramebufferTextureLayer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, 0, 0, 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

/// Makes room for rows 0 to `rows`: the first layer doubles until it is full, then layers are added, a quarter at once.
bool SharedTexels::growTexture(uint32_t rows) {
    const uint32_t side = rowTexels();
    if (rows <= uint32_t(m_layerRows) * uint32_t(m_layers)) return true;
    const int needed = int((rows + side - 1) / side), most = std::max(needed, m_layers + m_layers / 4);
    if (needed > m_maxLayers) return false;
    const int layerRows = rows > side ? int(side) : int(std::bit_ceil(rows)), layers = std::min(most, m_maxLayers);
    auto grown = makeTexture(layerRows, layers);
    if (!grown) return false;
    for (int layer = 0; layer < m_layers; ++layer)
        copy(m_texture.get(), {0, layer}, grown.get(), {0, layer}, m_layerRows);
    m_texture = std::move(grown);
    m_layerRows = layerRows;
    m_layers = layers;
    return true;
}

/// Copies by way of a third texture, because the GL does not copy from a texture into itself.
bool SharedTexels::move(uint32_t from, uint32_t to, uint32_t rows) {
    if (rows == 0) return true;
    const int side = int(rowTexels());
    const auto between = makeTexture(std::min(int(rows), side), 1);
    for (int left = int(rows), count = 0; left > 0 && between; left -= count, from += count, to += count) {
        const glm::ivec2 source = placeOf(from), target = placeOf(to);
        count = std::min({left, side - source.x, side - target.x});
        copy(m_texture.get(), source, between.get(), {0, 0}, count);
        copy(between.get(), {0, 0}, m_texture.get(), target, count);
    }
    return bool(between);
}

bool SharedTexels::grow(Rows& rows, uint32_t count) {
    if (count <= rows.count) return true;
    const uint32_t first = m_rows.allocate(count);
    if (!growTexture(first + count) || !move(rows.first, first, rows.count)) {
        m_rows.free(first, count);
        return false;
    }
    free(rows);
    rows = {first, count};
    return true;
}

void SharedTexels::free(const Rows& rows) {
    if (rows.count) m_rows.free(rows.first, rows.count);
}

void SharedTexels::upload(const Rows& rows, uint64_t offset, std::span<const std::byte> data) {
    RUBBLE_ASSERT(data.size() % m_texelBytes == 0 && "an upload of whole texels");
    const PixelFormat pixel = pixelFormat(m_internalFormat);
    const uint64_t side = rowTexels();
    uint64_t texel = rows.first * side + offset, left = data.size() / m_texelBytes;
    const std::byte* from = data.data();
    bindForUpload(GL_TEXTURE_2D_ARRAY, name());
    while (left > 0) {
        const uint64_t x = texel % side;
        const glm::ivec2 place = placeOf(uint32_t(texel / side));
        const bool isPart = x > 0 || left < side;  // of a row
        const uint64_t width = isPart ? std::min(side - x, left) : side;
        const uint64_t height = isPart ? 1 : std::min(left / side, side - uint64_t(place.x));
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, GLint(x), place.x, place.y, GLsizei(width), GLsizei(height), 1,
                        pixel.format, pixel.type, from);
        texel += width * height;
        left -= width * height;
        from += width * height * m_texelBytes;
    }
}

TexelStore::TexelStore(const GlLimits& limits)
    : m_limits(limits),
      m_isShared(limits.bufferTexels < kEnoughTexels || limits.textureUnits < kTextureUnits),
      m_placeholders(std::make_unique<Placeholders>()) {}

TexelStore::~TexelStore() = default;

std::shared_ptr<SharedTexels> TexelStore::of(GLenum internalFormat) {
    if (!m_isShared) return nullptr;
    const int numbers = pixelFormat(internalFormat).bytes / 4;
    const GLenum format = numbers == 1 ? GL_R32UI : numbers == 2 ? GL_RG32UI : GL_RGBA32UI;
    auto& shared = m_formats[size_t(numbers / 2)];
    if (!shared) shared = std::make_shared<SharedTexels>(format, m_limits);
    return shared;
}

std::string TexelStore::shaderDefines() const {
    return m_isShared ? "#define SHARED_TEXELS " + std::to_string(SharedTexels::sideBits(m_limits)) + "\n" : "";
}

TexelStore* TexelStore::current() {
    return g_current;
}

TexelStore::Use::Use(TexelStore& store) : m_before(std::exchange(g_current, &store)) {}

TexelStore::Use::~Use() {
    g_current = m_before;
}

}  // namespace rubble
