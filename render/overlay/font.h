#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// The distance field of a glyph: 128 on its outline, more inside, 0 and 255 kGlyphSpread texels away from it.
struct GlyphImage {
    glm::ivec2 size{0};   ///< texels, of which kGlyphEm are one em; none: a glyph without an outline
    glm::vec2 low{0.0f};  ///< em: its left upper corner from the pen, y down
    std::vector<uint8_t> texels;
};
inline constexpr int kGlyphEm = 32, kGlyphSpread = 8;

/// The outlines of a font. All lengths are in em.
class Font {
public:
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    /// The glyph of a character; that of what the font does not have is a box.
    uint32_t glyphOf(char32_t character) const;
    /// How far the pen goes.
    float advanceOf(uint32_t glyph) const;
    /// What two glyphs beside each other come closer by; negative where they do.
    float kerning(uint32_t left, uint32_t right) const;
    /// From a line's top to its baseline.
    float ascent() const;
    /// From one baseline to the next.
    float lineHeight() const;
    /// Draws a glyph.
    GlyphImage imageOf(uint32_t glyph) const;

private:
    friend class Fonts;
    struct Face;
    explicit Font(std::unique_ptr<Face> face);
    std::unique_ptr<Face> m_face;
    mutable std::unordered_map<uint32_t, float> m_advances;
};

/// The fonts that are open. One thread at a time.
class Fonts {
public:
    Fonts();
    ~Fonts();
    Fonts(const Fonts&) = delete;
    Fonts& operator=(const Fonts&) = delete;

    /// "" or "sans", "bold" and "mono" are DejaVu's; any other name is the path of a font's file. The font lives as
    /// long as this. An error says which file could not be read, or that the library was built without FreeType.
    Result<const Font*> find(const std::string& name);

private:
    struct Library;
    std::unique_ptr<Library> m_library;
    std::map<std::string, std::unique_ptr<Font>> m_fonts;
};

}  // namespace rubble
