// What the view shows of the level, and what it tells of a shape: the level stays as it is.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "editor/core/components.h"
#include "editor/core/editor.h"
#include "runtime/core/counted.h"

namespace editor {
namespace {

using Shapes = std::vector<rubble_shape>;

Shapes sortedShapes(const Editor& editor, const Arguments& arguments) {
    Shapes all = editor.objects(arguments, "what", {RUBBLE_KIND_SHAPE});
    std::ranges::sort(all);
    return all;
}

Shapes allShapes(Editor& editor) {
    Shapes all = editor.world().get_objects(RUBBLE_KIND_SHAPE);
    std::ranges::sort(all);
    return all;
}

void setHidden(Editor& editor, const Shapes& shapes) {
    editor.view().hidden = shapes;
    editor.say(fmt::format("{} of {} hidden", shapes.size(), rubble::counted(allShapes(editor).size(), "shape")));
}

void hide(Editor& editor, const Arguments& arguments) {
    Shapes all;
    std::ranges::set_union(editor.view().hidden, sortedShapes(editor, arguments), std::back_inserter(all));
    setHidden(editor, all);
}

void show(Editor& editor, const Arguments& arguments) {
    Shapes rest;
    std::ranges::set_difference(editor.view().hidden, sortedShapes(editor, arguments), std::back_inserter(rest));
    setHidden(editor, rest);
}

void hideOthers(Editor& editor, const Arguments& arguments) {
    Shapes others;
    std::ranges::set_difference(allShapes(editor), sortedShapes(editor, arguments), std::back_inserter(others));
    setHidden(editor, others);
}

void showOverlay(Editor& editor, const Arguments& arguments) {
    editor.view().overlays.*kOverlays[arguments.choice("name")].shown = arguments.flag("shown");
}

void listComponents(Editor& editor, const Arguments& arguments) {
    constexpr size_t kMaxListed = 100;
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    const Components components(editor.world(), shape);
    const std::vector<Component>& all = components.all();
    const auto anchored = std::ranges::count_if(all, &Component::isAnchored);
    editor.say(fmt::format("{}: {} anchored, {} loose", rubble::counted(all.size(), "component"), anchored,
                           all.size() - size_t(anchored)));
    for (size_t i = 0; i < std::min(all.size(), kMaxListed); ++i)
        editor.say(fmt::format("  {} from {},{},{}: {}", rubble::counted(all[i].voxels, "voxel"), all[i].low.x,
                               all[i].low.y, all[i].low.z,
                               all[i].isAnchored() ? fmt::format("anchored by {}", all[i].anchored) : "loose"));
}

/// The names of all overlays, as a parameter lists its choices.
std::string_view overlayNames() {
    static const std::string all = [] {
        std::string names;
        for (const OverlayName& each : kOverlays) names += (names.empty() ? "" : " ") + std::string(each.name);
        return names;
    }();
    return all;
}

}  // namespace

std::vector<Command> viewCommands() {
    const auto shapes = [](std::string_view otherwise) {
        return Parameter{"what", Type::Objects, "the shapes", otherwise};
    };
    return {
        {"hide",
         "view",
         Kind::View,
         "Leaves shapes out of the view. The level stays as it is, and they keep their shadows: below a hidden roof it "
         "is as dark as before.",
         {shapes("selected")},
         hide,
         "hide crate"},
        {"show", "view", Kind::View, "Shows shapes that are hidden.", {shapes("all")}, show, "show all"},
        {"hide_others",
         "view",
         Kind::View,
         "Shows these shapes in the view, and no others.",
         {shapes("selected")},
         hideOthers,
         "hide_others crate"},
        {"overlay",
         "view",
         Kind::View,
         "Draws something over the view, or no longer.",
         {{"name", Type::Choice, "what", kRequired, 0, 0, overlayNames()},
          {"shown", Type::Flag, "whether it is drawn", "yes"}},
         showOverlay,
         "overlay components"},
        {"components",
         "view",
         Kind::View,
         "Lists the parts of a shape that do not touch, and which of them anchors hold.",
         {{"shape", Type::Objects, "the shape", "selected"}},
         listComponents,
         "components parts"},
    };
}

}  // namespace editor
