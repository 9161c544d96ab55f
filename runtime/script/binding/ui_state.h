#pragma once
#include <rubble/rubble.h>

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rubble::script {

/// What UiTranslate() and its like have set: between UiPush() and UiPop().
struct UiState {
    std::array<double, 6> transform{1, 0, 0, 1, 0, 0};  ///< as in rubble_overlay_item
    double width = 1920.0, height = 1080.0;             ///< of the window
    std::array<double, 4> clip{};                       ///< on the surface; all 0: none
    std::array<double, 4> color{1, 1, 1, 1}, filter{1, 1, 1, 1};
    std::array<double, 2> align{};  ///< 0 left or top, 1 right or bottom
    bool isOnBaseline = true;       ///< texts: no vertical alignment was asked for
    std::string font;
    double fontSize = 24.0, wrap = 0.0;
    double outline = 0.0, shadowDistance = 0.0, shadowBlur = 0.0;
    std::array<double, 4> outlineColor{}, shadowColor{};
    bool isInWorld = false, isOccluded = false;
    std::array<double, 3> position{};
    std::array<double, 4> rotation{0, 0, 0, 1};
    double scale = 0.01;
};

/// Something that a script has drawn. Its row points to no text until ScriptHost::draw() hands it on.
struct UiItem {
    rubble_overlay_item row;
    std::string text, font;
};

/// An image that scripts have read.
struct UiImage {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> pixels;        ///< RGBA, rows from the top
    std::set<rubble_renderer> holders;  ///< that have it
};

/// What scripts draw of a frame, and where.
struct UiFrame {
    double width = 1920.0, height = 1080.0;  ///< of the canvas that scripts draw on: always 1080 high
    double pixels = 1.0;                     ///< of the view in a unit of the canvas
    rubble_view view = {};                   ///< of the last frame
    bool isOpen = false;                     ///< draw() of scripts is being called: only then they draw
    std::vector<UiItem> items;
    std::map<std::string, UiImage> images;  ///< by path in the scripts' folder
    size_t imageBytes = 0;                  ///< of all of them
};

}  // namespace rubble::script
