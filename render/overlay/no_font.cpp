// Fonts of a library that was built without FreeType, as for browsers: there are none.
#include "render/overlay/font.h"

namespace rubble {

struct Fonts::Library {};
struct Font::Face {};

Font::Font(std::unique_ptr<Face> face) : m_face(std::move(face)) {}
Font::~Font() = default;
uint32_t Font::glyphOf(char32_t) const {
    return 0;
}
float Font::advanceOf(uint32_t) const {
    return 0.0f;
}
float Font::kerning(uint32_t, uint32_t) const {
    return 0.0f;
}
float Font::ascent() const {
    return 0.0f;
}
float Font::lineHeight() const {
    return 0.0f;
}
GlyphImage Font::imageOf(uint32_t) const {
    return {};
}

Fonts::Fonts() = default;
Fonts::~Fonts() = default;
Result<const Font*> Fonts::find(const std::string&) {
    return Error{"this library was built without FreeType: expected boxes, lines and images alone, found a text"};
}

}  // namespace rubble
