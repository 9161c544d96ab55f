#pragma once
#include <algorithm>
#include <rubble/rubble.hpp>
#include <vector>

namespace editor {

/// What is drawn over the view.
struct Overlays {
    bool grid = false, anchors = false, components = false, load = false, contacts = false, sleep = false,
         joints = false, lights = false, groups = false, bricks = false;
};

/// An overlay as commands and people call it.
struct OverlayName {
    const char *name, *label;
    bool Overlays::*shown;
    const char* tip;
};
/// All of them.
inline constexpr OverlayName kOverlays[] = {
    {"grid", "ground grid", &Overlays::grid, "Lines of a metre at height 0"},
    {"anchors", "anchors", &Overlays::anchors,
     "What holds static shapes to the world: of the selected shape, or of all"},
    {"components", "components", &Overlays::components,
     "Parts of the selected shape that do not touch, each in a colour of its own: green to violet where anchors hold "
     "them, red to magenta where they are loose; voxels in anchors are orange"},
    {"load", "load", &Overlays::load,
     "Where the selected shape would break first under more load, from red to yellow: tried in a copy of the level "
     "by halving its strength. Takes a while in large levels"},
    {"contacts", "contacts", &Overlays::contacts,
     "In play: where bodies begin to touch, meet or slide in the last half second, longer where they push harder"},
    {"sleep", "sleep", &Overlays::sleep, "Free bodies: awake ones in the accent, sleeping ones grey"},
    {"joints", "joints", &Overlays::joints, "Ends of joints and ropes"},
    {"lights", "lights", &Overlays::lights, "Where lights are"},
    {"groups", "light groups", &Overlays::groups, "What goes out together, and where its wire begins; grey: it is out"},
    {"bricks", "bricks", &Overlays::bricks,
     "In play: cubes of 8 x 8 x 8 cells in which voxels changed in the last half second"},
};

/// What the view shows of the level. It is no part of it: no step of the history, no file and no journal knows it.
struct ViewState {
    std::vector<rubble_shape> hidden;  ///< shapes that it leaves out, in ascending order
    Overlays overlays;

    /// Whether it leaves a shape out.
    bool hides(rubble_shape shape) const { return std::ranges::binary_search(hidden, shape); }
};

}  // namespace editor
