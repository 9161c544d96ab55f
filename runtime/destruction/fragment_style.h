#pragma once
#include <cstdint>
#include <string_view>

namespace rubble {

/// How the voxels of a zone that breaks are assigned to fragments.
enum class FragmentPattern : uint8_t {
    None,   ///< it does not break
    Cells,  ///< cells of a seeded Voronoi diagram, stretched along the grain
    Bond,   ///< blocks of proportions 2 : 1 : 1 in running bond, as in a brick wall
};

/// How a material breaks, by the name in Material::fragments. Integers, so that it breaks the same on every machine.
struct FragmentStyle {
    std::string_view name;
    FragmentPattern pattern = FragmentPattern::Cells;
    int size = 300;          ///< of a fragment, mm; half of that near the hit
    int elongation = 1;      ///< length of a fragment over its width; the grain is the longest axis of what is hit
    int roughness = 64;      ///< displacement of the borders, in 1/255 of a fragment's size
    int dust = 128;          ///< radius within which all becomes dust, in 1/255 of the brush's radius
    int breakRadius = 255;   ///< radius within which it breaks, in 1/255 of the brush's radius
    bool wholePane = false;  ///< the whole pane that is hit breaks (findPane()); its cracks are one cell wide
    double toughness = 1.0;  ///< the impact that breaks it, in multiples of WorldSettings::impactThreshold
};

/// The style of this name; "chunk" if there is none.
const FragmentStyle& fragmentStyle(std::string_view name);

struct Material;
/// The impact that breaks a material, in multiples of WorldSettings::impactThreshold. For materials up to
/// Hardness::Hard.
double impactToughness(const Material& material);

}  // namespace rubble
