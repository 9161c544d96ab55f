#pragma once
#include <cstdint>
#include <string_view>

namespace rubble {

/// How the voxels of a style are shared out among fragments.
enum class FragmentPattern : uint8_t {
    None,   ///< it does not come apart
    Cells,  ///< cells of a seeded Voronoi diagram, stretched along the grain
    Bond,   ///< bricks of two to one to one in running bond
};

/// How a material comes apart: what Material::fragments names. Data; integers, so that it breaks alike everywhere.
struct FragmentStyle {
    std::string_view name;
    FragmentPattern pattern = FragmentPattern::Cells;
    int size = 300;         ///< of a fragment, mm; half of that near the hit
    int elongation = 1;     ///< times as long along the grain: the longest axis of what is hit
    int roughness = 64;     ///< how far its borders stray, of 255 of its size
    int dust = 128;         ///< share of the broken radius within which only dust is left, of 255
    int breakRadius = 255;  ///< share of the broken radius within which it breaks, of 255
    bool wholePane =
        false;  ///< all that is connected to the hit and of its material breaks with it; cracks are a cell of dust wide
    double toughness = 1.0;  ///< times WorldSettings::impactThreshold before an impact breaks it
};

/// The style of this name; that of "chunk" if there is none.
const FragmentStyle& fragmentStyle(std::string_view name);

struct Material;
/// How many times WorldSettings::impactThreshold an impact must be to break a material up to Hardness::Hard.
double impactToughness(const Material& material);

}  // namespace rubble
