#include "samples/scenes/lettering.h"

namespace rubble::scenes {

const uint8_t* letterRows(char letter) {
    struct Glyph {
        char letter;
        uint8_t rows[kLetterHeight];
    };
    static constexpr Glyph kGlyphs[] = {
        {'B', {0b11110, 0b10001, 0b10001, 0b11110, 0b10001, 0b10001, 0b11110}},
        {'E', {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b11111}},
        {'L', {0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b11111}},
        {'M', {0b10001, 0b11011, 0b10101, 0b10101, 0b10001, 0b10001, 0b10001}},
        {'O', {0b01110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110}},
        {'R', {0b11110, 0b10001, 0b10001, 0b11110, 0b10100, 0b10010, 0b10001}},
        {'S', {0b01111, 0b10000, 0b10000, 0b01110, 0b00001, 0b00001, 0b11110}},
        {'U', {0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110}},
    };
    for (const Glyph& glyph : kGlyphs)
        if (glyph.letter == letter) return glyph.rows;
    return nullptr;
}

void drawLettering(Canvas& canvas, ivec3 lowLeft, std::string_view text, int scale, Swatch swatch) {
    for (size_t i = 0; i < text.size(); ++i) {
        const uint8_t* rows = letterRows(text[i]);
        if (!rows) continue;
        for (int row = 0; row < kLetterHeight; ++row)
            for (int column = 0; column < kLetterWidth; ++column) {
                if (!(rows[row] >> (kLetterWidth - 1 - column) & 1)) continue;
                const ivec3 low =
                    lowLeft + ivec3((int(i) * kLetterAdvance + column) * scale, (kLetterHeight - 1 - row) * scale, 0);
                canvas.box(low, low + ivec3(scale, scale, 1), swatch);
            }
    }
}

}  // namespace rubble::scenes
