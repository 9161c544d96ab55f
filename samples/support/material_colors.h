#pragma once
#include <cstdint>

namespace rubble {

/// A colour for an entry of the palette that new shapes of rubble.h have, which is white: sRGB, and opacity.
struct MaterialColor {
    uint32_t entry;
    uint8_t rgb[3], opacity = 255;
};
/// Wood, concrete, brick, plaster, metal, plastic, glass, rubber.
inline constexpr MaterialColor kMaterialColors[] = {
    {5, {160, 108, 60}}, {6, {148, 146, 142}}, {7, {164, 78, 56}},        {8, {205, 196, 178}},
    {9, {88, 96, 110}},  {11, {40, 84, 150}},  {15, {170, 215, 220}, 70}, {19, {38, 38, 42}}};

}  // namespace rubble
