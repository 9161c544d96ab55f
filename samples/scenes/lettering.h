#pragma once
#include <string_view>

#include "samples/scenes/canvas.h"

namespace rubble::scenes {

inline constexpr int kLetterWidth = 5, kLetterHeight = 7, kLetterAdvance = 6;

/// Writes capital letters into the plane z = lowLeft.z, from -x to +x; a pixel of a letter is scale x scale cells.
/// Letters without a glyph are skipped: only those that the scenes need have one.
void drawLettering(Canvas& canvas, ivec3 lowLeft, std::string_view text, int scale, Swatch swatch);
/// The rows of a letter's glyph, the topmost first; bit 4 is the leftmost of five columns. Null if there is no glyph.
const uint8_t* letterRows(char letter);

}  // namespace rubble::scenes
