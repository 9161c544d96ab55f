#include "runtime/destruction/fragment_style.h"

#include <algorithm>
#include <array>

#include "runtime/voxel/material.h"

namespace rubble {
namespace {

using enum FragmentPattern;

constexpr auto kStyles = std::to_array<FragmentStyle>({
    //  name, pattern, size, elongation, roughness, dust, break radius, whole pane, toughness
    {"none", None, 300, 1, 0, 0, 0, false, 1e9},
    {"chunk", Cells, 450, 1, 90, 128, 255, false, 1.0},
    {"bond", Bond, 300, 1, 40, 120, 255, false, 0.8},
    {"splinter", Cells, 200, 5, 110, 60, 255, false, 0.6},
    {"pane", Cells, 600, 1, 20, 30, 255, true, 0.03},
    {"tear", Cells, 600, 2, 30, 40, 150, false, 4.0},
    {"crumble", Cells, 250, 1, 160, 190, 255, false, 0.4},
});

/// By Hardness: multiplies the toughness of the style.
constexpr std::array<double, 3> kClassToughness = {1.0, 2.0, 8.0};

}  // namespace

const FragmentStyle& fragmentStyle(std::string_view name) {
    const auto found =
        std::find_if(kStyles.begin(), kStyles.end(), [&](const FragmentStyle& style) { return style.name == name; });
    return found == kStyles.end() ? kStyles[1] : *found;
}

double impactToughness(const Material& material) {
    return fragmentStyle(material.fragments).toughness * kClassToughness.at(size_t(material.hardness));
}

}  // namespace rubble
