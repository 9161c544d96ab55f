#pragma once
#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

#include "render/overlay/font.h"

namespace rubble {

/// How a text is set. Lengths are those of the item's surface.
struct TextStyle {
    float size = 16.0f;  ///< one em
    float width = 0.0f;  ///< lines are broken between words that reach beyond, or in a longer word; 0: never
    float align = 0.0f;  ///< of lines within the longest one: 0 left, 1 right
};

/// A text as lines of glyphs.
struct TextLayout {
    /// A glyph whose pen stands at a place: x from the left side of the text, y from its top down to the baseline.
    struct Glyph {
        uint32_t glyph;
        glm::vec2 pen;
    };
    std::vector<Glyph> glyphs;
    glm::vec2 size{0.0f};  ///< of its longest line, and of all lines
};

/// Sets a UTF-8 text. Bytes that are no UTF-8 become U+FFFD, a line feed begins a line.
TextLayout layOut(const Font& font, std::string_view text, const TextStyle& style);

/// The characters of a UTF-8 text.
std::vector<char32_t> charactersOf(std::string_view text);

}  // namespace rubble
