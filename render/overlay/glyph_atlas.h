#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <utility>
#include <vector>

#include "render/overlay/font.h"

namespace rubble {

/// The distance fields of the glyphs that have been drawn, in one image that grows: rows of glyphs, one below the
/// other.
class GlyphAtlas {
public:
    /// maxSide: the longest side that a texture may have, texels.
    explicit GlyphAtlas(int maxSide) : m_maxSide(maxSide) {}

    /// Where a glyph is.
    struct Place {
        glm::ivec2 low{0}, size{0};  ///< texels; no size: it has no outline
        glm::vec2 offset{0.0f};      ///< GlyphImage::low
    };
    /// Adds the glyph if it is not there yet; null: there is no room for it.
    const Place* find(const Font& font, uint32_t glyph);
    /// Forgets all glyphs.
    void clear();

    /// Of the image, in texels.
    glm::ivec2 size() const { return m_size; }
    /// Its texels, rows from the top.
    const std::vector<uint8_t>& texels() const { return m_texels; }
    /// Changes with the image.
    uint64_t version() const { return m_version; }

private:
    bool place(Place& at);
    int m_maxSide;
    glm::ivec2 m_size{0}, m_pen{0};
    int m_rowHeight = 0;
    std::vector<uint8_t> m_texels;
    std::map<std::pair<const Font*, uint32_t>, Place> m_places;
    uint64_t m_version = 0;
};

}  // namespace rubble
