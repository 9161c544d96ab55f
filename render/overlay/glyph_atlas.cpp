#include "render/overlay/glyph_atlas.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr int kWidth = 1024, kFirstHeight = 256;  ///< texels

}  // namespace

/// Finds room for a glyph of at.size.
bool GlyphAtlas::place(Place& at) {
    if (m_pen.x + at.size.x > std::min(kWidth, m_maxSide)) m_pen = {0, m_pen.y + m_rowHeight}, m_rowHeight = 0;
    if (at.size.x > std::min(kWidth, m_maxSide) || m_pen.y + at.size.y > m_maxSide) return false;
    while (m_pen.y + at.size.y > m_size.y) {
        m_size = {std::min(kWidth, m_maxSide), std::min(m_maxSide, std::max(kFirstHeight, m_size.y * 2))};
        m_texels.resize(size_t(m_size.x) * size_t(m_size.y));
    }
    at.low = m_pen;
    m_pen.x += at.size.x;
    m_rowHeight = std::max(m_rowHeight, at.size.y);
    return true;
}

const GlyphAtlas::Place* GlyphAtlas::find(const Font& font, uint32_t glyph) {
    const auto found = m_places.find({&font, glyph});
    if (found != m_places.end()) return &found->second;
    const GlyphImage image = font.imageOf(glyph);
    Place at{{0, 0}, image.size, image.low};
    if (image.size.x && !place(at)) return nullptr;
    for (int row = 0; row < at.size.y; ++row)
        std::copy_n(image.texels.begin() + ptrdiff_t(row) * at.size.x, at.size.x,
                    m_texels.begin() + ptrdiff_t(at.low.y + row) * m_size.x + at.low.x);
    ++m_version;
    return &(m_places[{&font, glyph}] = at);
}

void GlyphAtlas::clear() {
    m_places.clear();
    std::fill(m_texels.begin(), m_texels.end(), uint8_t(0));
    m_pen = {0, 0}, m_rowHeight = 0;
    ++m_version;
}

}  // namespace rubble
