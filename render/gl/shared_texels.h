#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>

#include "render/gl/gl_limits.h"
#include "render/gl/name.h"
#include "runtime/core/index_allocator.h"

namespace rubble {

class Placeholders;

/// Many arrays of texels of one format in one texture, which is a stack of layers of 2D texels. An array is a run of
/// whole rows; rows go on from layer to layer. [render-thread]
class SharedTexels {
public:
    /// internalFormat: of a texel. Nothing is allocated yet.
    SharedTexels(GLenum internalFormat, const GlLimits& limits);

    /// A run of rows; of no rows if it is empty.
    struct Rows {
        uint32_t first = 0, count = 0;
    };
    /// Makes a run at least `count` rows long; what it holds is kept. False if the texture cannot hold that: then the
    /// run is as before.
    bool grow(Rows& rows, uint32_t count);
    /// Gives a run back.
    void free(const Rows& rows);
    /// Replaces texels of a run, from the texel `offset` on.
    void upload(const Rows& rows, uint64_t offset, std::span<const std::byte> data);

    /// Texels in a row.
    uint32_t rowTexels() const { return 1u << m_sideBits; }
    /// As a power of two: texels in a row, and rows in a layer.
    int sideBits() const { return m_sideBits; }
    /// Bytes of a texel.
    uint32_t texelBytes() const { return m_texelBytes; }
    /// The GL's name of the texture, a GL_TEXTURE_2D_ARRAY; 0: nothing is allocated.
    GLuint name() const { return m_texture.get(); }
    /// As a power of two, the side of layers under these limits.
    static int sideBits(const GlLimits& limits);

private:
    bool growTexture(uint32_t rows);
    GlName<TextureKind> makeTexture(int rows, int layers) const;
    /// Copies rows between layers of two textures.
    void copy(GLuint from, glm::ivec2 rowAndLayer, GLuint to, glm::ivec2 toRowAndLayer, int rows);
    bool move(uint32_t from, uint32_t to, uint32_t rows);
    /// The row in its layer, and the layer.
    glm::ivec2 placeOf(uint32_t row) const { return {int(row & (rowTexels() - 1)), int(row >> m_sideBits)}; }

    GLenum m_internalFormat;
    uint32_t m_texelBytes;
    int m_sideBits, m_maxLayers;
    int m_layerRows = 0, m_layers = 0;  ///< allocated; several layers are of all rows
    GlName<TextureKind> m_texture;
    GlName<FramebufferKind> m_reader;  ///< to copy from
    RangeAllocator m_rows;
};

/// Where the arrays of texels of one renderer lie. GL 3.3 promises buffer textures of only 65,536 texels, and 16 of
/// them in a program. Where a context has not much more, all arrays of a format share one texture. [render-thread]
class TexelStore {
public:
    /// Of a context with these limits.
    explicit TexelStore(const GlLimits& limits);
    ~TexelStore();
    TexelStore(const TexelStore&) = delete;
    TexelStore& operator=(const TexelStore&) = delete;
    /// The texture of a format's arrays; null: each array is a buffer texture of its own.
    std::shared_ptr<SharedTexels> of(GLenum internalFormat);
    /// As given to the constructor.
    const GlLimits& limits() const { return m_limits; }
    /// Whether arrays share textures.
    bool isShared() const { return m_isShared; }
    /// What programs read where there is no texture for a sampler.
    Placeholders& placeholders() const { return *m_placeholders; }
    /// What shaders must be built with: lib/texels.glsl.
    std::string shaderDefines() const;

    /// The store of the innermost Use of this thread; null: there is none.
    static TexelStore* current();
    /// While it lives, arrays of this thread are made in this store.
    class Use {
    public:
        /// `store` must outlive it.
        explicit Use(TexelStore& store);
        ~Use();
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;

    private:
        TexelStore* m_before;
    };

private:
    GlLimits m_limits;
    bool m_isShared;
    std::array<std::shared_ptr<SharedTexels>, 3> m_formats;  ///< of one, two and four numbers a texel
    std::unique_ptr<Placeholders> m_placeholders;
};

}  // namespace rubble
