#include "render/overlay/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_MODULE_H

namespace rubble {

struct Fonts::Library {
    FT_Library library = nullptr;
    ~Library() {
        if (library) FT_Done_FreeType(library);
    }
};

struct Font::Face {
    FT_Face face = nullptr;
    ~Face() { FT_Done_Face(face); }
};

namespace {

/// The file of a font by its name.
std::string pathOf(const std::string& name) {
    const std::string folder = RUBBLE_FONT_FOLDER "/";
    if (name.empty() || name == "sans") return folder + "DejaVuSans.ttf";
    if (name == "bold") return folder + "DejaVuSans-Bold.ttf";
    if (name == "mono") return folder + "DejaVuSansMono.ttf";
    return name;
}

/// FreeType's lengths, of 1/64 texel.
float emOf(FT_Pos length) {
    return float(length) / float(64 * kGlyphEm);
}

}  // namespace

Font::Font(std::unique_ptr<Face> face) : m_face(std::move(face)) {}
Font::~Font() = default;

uint32_t Font::glyphOf(char32_t character) const {
    return FT_Get_Char_Index(m_face->face, character);
}

float Font::advanceOf(uint32_t glyph) const {
    const auto [at, isNew] = m_advances.try_emplace(glyph, 0.0f);
    if (isNew && !FT_Load_Glyph(m_face->face, glyph, FT_LOAD_NO_HINTING))
        at->second = emOf(m_face->face->glyph->advance.x);
    return at->second;
}

float Font::kerning(uint32_t left, uint32_t right) const {
    FT_Vector by = {};
    if (FT_HAS_KERNING(m_face->face)) FT_Get_Kerning(m_face->face, left, right, FT_KERNING_UNFITTED, &by);
    return emOf(by.x);
}

float Font::ascent() const {
    return float(m_face->face->ascender) / float(m_face->face->units_per_EM);
}

float Font::lineHeight() const {
    return float(m_face->face->height) / float(m_face->face->units_per_EM);
}

/// From a bitmap, because FreeType's field of outlines has faults where contours of a glyph overlap.
GlyphImage Font::imageOf(uint32_t glyph) const {
    GlyphImage image;
    const FT_GlyphSlot slot = m_face->face->glyph;
    if (FT_Load_Glyph(m_face->face, glyph, FT_LOAD_NO_HINTING) || FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) ||
        !slot->bitmap.width || FT_Render_Glyph(slot, FT_RENDER_MODE_SDF))
        return image;
    image.size = {int(slot->bitmap.width), int(slot->bitmap.rows)};
    image.low = glm::vec2(slot->bitmap_left, -slot->bitmap_top) / float(kGlyphEm);
    for (int row = 0; row < image.size.y; ++row) {
        const uint8_t* texels = slot->bitmap.buffer + ptrdiff_t(row) * slot->bitmap.pitch;
        image.texels.insert(image.texels.end(), texels, texels + image.size.x);
    }
    return image;
}

Fonts::Fonts() : m_library(std::make_unique<Library>()) {
    if (FT_Init_FreeType(&m_library->library)) m_library->library = nullptr;
    FT_Int spread = kGlyphSpread;
    if (m_library->library) FT_Property_Set(m_library->library, "bsdf", "spread", &spread);
}
Fonts::~Fonts() = default;

Result<const Font*> Fonts::find(const std::string& name) {
    const auto found = m_fonts.find(name);
    if (found != m_fonts.end()) return found->second.get();
    const std::string path = pathOf(name);
    auto face = std::make_unique<Font::Face>();
    if (!m_library->library || FT_New_Face(m_library->library, path.c_str(), 0, &face->face)) {
        const bool isOwn = path != name;
        return Error{path + ": expected the file of a font" +
                     (isOwn ? ", which is in Debian's package fonts-dejavu-core" : "")};
    }
    if (!FT_IS_SCALABLE(face->face) || FT_Set_Pixel_Sizes(face->face, kGlyphEm, kGlyphEm))
        return Error{path + ": expected a font with outlines, found one of bitmaps"};
    return (m_fonts[name] = std::unique_ptr<Font>(new Font(std::move(face)))).get();
}

}  // namespace rubble
