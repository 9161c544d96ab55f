#include "render/overlay/text_layout.h"

#include <algorithm>
#include <optional>

namespace rubble {
namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr int kTabSpaces = 4;

/// How many bytes the sequence has that begins with this one; 0: none begins with it.
size_t lengthOf(uint8_t first) {
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first < 0xE0) return 2;
    if (first >= 0xE0 && first < 0xF0) return 3;
    return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// The character of a sequence; nothing where it is none, or one that a shorter sequence is for.
std::optional<char32_t> decode(std::string_view sequence) {
    static constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    const size_t length = sequence.size();
    char32_t character = length == 1 ? uint8_t(sequence[0]) : uint8_t(sequence[0]) & (0x7Fu >> length);
    for (size_t i = 1; i < length; ++i) {
        if ((uint8_t(sequence[i]) & 0xC0) != 0x80) return {};
        character = character << 6 | (uint8_t(sequence[i]) & 0x3Fu);
    }
    const bool isSurrogate = character >= 0xD800 && character < 0xE000;
    if (character < kLeast[length] || isSurrogate || character > 0x10FFFF) return {};
    return character;
}

/// Sets characters one after the other.
class Setter {
public:
    Setter(const Font& font, const TextStyle& style) : m_font(font), m_style(style) {}

    void add(char32_t character) {
        if (character == '\n') return endLine(m_layout.glyphs.size());
        if (character == '\t') {
            for (int i = 0; i < kTabSpaces; ++i) add(' ');
            return;
        }
        const uint32_t glyph = m_font.glyphOf(character);
        if (m_hasBefore) m_pen += m_font.kerning(m_before, glyph) * m_style.size;
        const float next = m_pen + m_font.advanceOf(glyph) * m_style.size;
        if (m_style.width > 0.0f && next > m_style.width && character != ' ' && m_layout.glyphs.size() > m_line) {
            endLine(m_word > m_line ? m_word : m_layout.glyphs.size());
            return add(character);
        }
        m_layout.glyphs.push_back({glyph, {m_pen, 0.0f}});
        m_pen = next, m_before = glyph, m_hasBefore = true;
        if (character == ' ') m_word = m_layout.glyphs.size();
    }

    TextLayout finish() {
        endLine(m_layout.glyphs.size());
        for (size_t i = 0, line = 0; i < m_layout.glyphs.size(); ++i) {
            while (i >= m_lines[line].end) ++line;
            TextLayout::Glyph& glyph = m_layout.glyphs[i];
            glyph.pen.x += (m_layout.size.x - m_lines[line].width) * m_style.align;
            glyph.pen.y = (float(line) * m_font.lineHeight() + m_font.ascent()) * m_style.size;
        }
        m_layout.size.y = float(m_lines.size()) * m_font.lineHeight() * m_style.size;
        return std::move(m_layout);
    }

private:
    struct Line {
        size_t end;
        float width;
    };

    /// Ends the line before a glyph; the glyphs from there on begin the next one. Spaces at its end have no width.
    void endLine(size_t end) {
        std::vector<TextLayout::Glyph>& glyphs = m_layout.glyphs;
        const uint32_t space = m_font.glyphOf(' ');
        size_t last = end;
        while (last > m_line && glyphs[last - 1].glyph == space) --last;
        const auto endOf = [&](const TextLayout::Glyph& glyph) {
            return glyph.pen.x + m_font.advanceOf(glyph.glyph) * m_style.size;
        };
        m_lines.push_back({end, last > m_line ? endOf(glyphs[last - 1]) : 0.0f});
        m_layout.size.x = std::max(m_layout.size.x, m_lines.back().width);
        const float start = end < glyphs.size() ? glyphs[end].pen.x : m_pen;
        for (size_t i = end; i < glyphs.size(); ++i) glyphs[i].pen.x -= start;
        m_pen -= start;
        m_line = m_word = end;
        m_hasBefore = end < glyphs.size();
    }

    const Font& m_font;
    const TextStyle& m_style;
    TextLayout m_layout;
    std::vector<Line> m_lines;
    size_t m_line = 0, m_word = 0;  ///< glyphs before this line, and before the last word
    float m_pen = 0.0f;
    uint32_t m_before = 0;
    bool m_hasBefore = false;
};

}  // namespace

std::vector<char32_t> charactersOf(std::string_view text) {
    std::vector<char32_t> characters;
    for (size_t i = 0; i < text.size();) {
        const size_t length = lengthOf(uint8_t(text[i]));
        std::optional<char32_t> character;
        if (length && i + length <= text.size()) character = decode(text.substr(i, length));
        characters.push_back(character.value_or(kReplacement));
        i += character ? length : 1;
    }
    return characters;
}

TextLayout layOut(const Font& font, std::string_view text, const TextStyle& style) {
    Setter setter(font, style);
    for (const char32_t character : charactersOf(text)) setter.add(character);
    return setter.finish();
}

}  // namespace rubble
