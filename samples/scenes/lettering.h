#pragma once
#include <string_view>

#include "samples/scenes/canvas.h"

namespace rubble::scenes {

inline constexpr int kLetterWidth = 5, kLetterHeight = 7, kLetterAdvance = 6;

/// Writes capitals (of the letters that the scenes need) into the plane z, reading from -x to +x, one cell a pixel
/// times scale.
void drawLettering(Canvas& canvas, ivec3 lowLeft, std::string_view text, int scale, Swatch swatch);
/// The rows of a letter, topmost first, bit 4 the leftmost of five columns; null if there is none.
const uint8_t* letterRows(char letter);

}  // namespace rubble::scenes
