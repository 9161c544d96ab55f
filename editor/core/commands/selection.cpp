// What is selected: objects, and cells of one shape.
#include <fmt/format.h>

#include <algorithm>

#include "editor/core/cells.h"
#include "editor/core/editor.h"
#include "runtime/core/counted.h"

namespace editor {
namespace {

const Parameter kShape{"shape", Type::Objects, "the shape whose cells these are", "selected"};

void select(Editor& editor, const Arguments& arguments) {
    const std::vector<uint64_t> found =
        editor.objects(arguments, "what",
                       {RUBBLE_KIND_BODY, RUBBLE_KIND_SHAPE, RUBBLE_KIND_LIGHT, RUBBLE_KIND_LIGHT_GROUP,
                        RUBBLE_KIND_WATER, RUBBLE_KIND_TRIGGER, RUBBLE_KIND_CHARACTER, RUBBLE_KIND_JOINT});
    std::vector<uint64_t>& now = editor.selection().objects;
    if (!arguments.flag("more")) now.clear();
    for (const uint64_t each : found)
        if (std::find(now.begin(), now.end(), each) == now.end()) now.push_back(each);
    editor.say(fmt::format("{} selected", now.size()));
}

void deselect(Editor& editor, const Arguments&) {
    editor.selection() = {};
}

/// Selects the cells of a box for which isIn(index) is true.
template <class F>
void selectWhere(Editor& editor, rubble_shape shape, const Cells& box, F&& isIn) {
    const Cells inside = shared(box, gridOf(editor.world(), shape));
    const std::vector<uint8_t> voxels = readCells(editor.world(), shape, inside);
    CellSet set{shape, inside.low, inside.size, std::vector<uint8_t>(voxels.size())};
    std::transform(voxels.begin(), voxels.end(), set.mask.begin(), [&](uint8_t index) { return uint8_t(isIn(index)); });
    editor.say(rubble::counted(size_t(std::count(set.mask.begin(), set.mask.end(), 1)), "cell") + " selected");
    editor.selection().cells = std::move(set);
}

void selectBox(Editor& editor, const Arguments& arguments) {
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    selectWhere(editor, shape, between(arguments.cell("from"), arguments.cell("to")), [](uint8_t) { return true; });
}

void selectColor(Editor& editor, const Arguments& arguments) {
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    const int wanted = arguments.whole("index");
    selectWhere(editor, shape, gridOf(editor.world(), shape), [=](uint8_t index) { return index == wanted; });
}

void selectConnected(Editor& editor, const Arguments& arguments) {
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    CellSet set = connectedCells(editor.world(), shape, arguments.cell("cell"));
    editor.say(rubble::counted(size_t(std::count(set.mask.begin(), set.mask.end(), 1)), "cell") + " selected");
    editor.selection().cells = std::move(set);
}

void list(Editor& editor, const Arguments&) {
    const rubble::World& world = editor.world();
    for (const rubble_body_state& body : world.get_body_states()) {
        editor.say(fmt::format("body #{} '{}' {}at {:.2f},{:.2f},{:.2f}", body.body, nameOf(world, body.body),
                               body.flags & RUBBLE_BODY_STATIC ? "static " : "", body.position[0], body.position[1],
                               body.position[2]));
        for (const rubble_shape_state& shape : world.get_shape_states(body.body))
            editor.say(fmt::format("  shape #{} '{}' {},{},{} cells of {:.3f} m, {}{}", shape.shape,
                                   nameOf(world, shape.shape), shape.size[0], shape.size[1], shape.size[2],
                                   shape.voxel_size, rubble::counted(shape.voxel_count, "voxel"),
                                   editor.view().hides(shape.shape) ? ", hidden" : ""));
    }
    for (const uint32_t kind : {RUBBLE_KIND_JOINT, RUBBLE_KIND_LIGHT, RUBBLE_KIND_LIGHT_GROUP, RUBBLE_KIND_WATER,
                                RUBBLE_KIND_TRIGGER, RUBBLE_KIND_CHARACTER})
        for (const uint64_t each : world.get_objects(kind))
            editor.say(fmt::format("{} #{} '{}'", nameOfKind(kind), each, nameOf(world, each)));
}

}  // namespace

std::vector<Command> selectionCommands() {
    const Parameter index{"index", Type::Whole, "entry of the palette", kRequired, 1, 255};
    const auto cell = [](std::string_view name, std::string_view help) {
        return Parameter{name, Type::Cell, help, kRequired, -4096, 4096};
    };
    return {
        {"select",
         "selection",
         Kind::View,
         "Selects objects.",
         {{"what", Type::Objects, "the objects", kRequired},
          {"more", Type::Flag, "what is selected already stays so", "no"}},
         select,
         "select crate"},
        {"deselect", "selection", Kind::View, "Selects nothing: neither objects nor cells.", {}, deselect, "deselect"},
        {"select_box",
         "selection",
         Kind::View,
         "Selects the cells of a box.",
         {cell("from", "one corner"), cell("to", "the opposite corner"), kShape},
         selectBox,
         "select_box 0,0,0 3,3,3 crate"},
        {"select_color",
         "selection",
         Kind::View,
         "Selects the cells that hold an entry of the palette.",
         {index, kShape},
         selectColor,
         "select_color 5 crate"},
        {"select_connected",
         "selection",
         Kind::View,
         "Selects all cells that are joined to one and hold the same.",
         {cell("cell", "where it begins"), kShape},
         selectConnected,
         "select_connected 0,0,0 crate"},
        {"list", "selection", Kind::View, "Lists all objects with their handles and names.", {}, list, "list"},
    };
}

}  // namespace editor
