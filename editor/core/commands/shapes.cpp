// What works on whole shapes.
#include <algorithm>

#include "editor/core/cells.h"
#include "editor/core/editor.h"

namespace editor {
namespace {

const Parameter kShape{"shape", Type::Objects, "the shape", "selected"};
const Parameter kShapes{"shape", Type::Objects, "the shapes", "selected"};
const Parameter kAxis{"axis", Type::Choice, "of its grid", kRequired, 0, 0, "x y z"};

template <class F>
void forEachShape(Editor& editor, const Arguments& arguments, F&& f) {
    for (const rubble_shape shape : editor.objects(arguments, "shape", {RUBBLE_KIND_SHAPE})) f(shape);
}

void trim(Editor& editor, const Arguments& arguments) {
    forEachShape(editor, arguments, [&](rubble_shape shape) { editor.world().trim_shape(shape); });
}

void resize(Editor& editor, const Arguments& arguments) {
    rubble_resize change{};
    change.shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    const glm::ivec3 low = arguments.cell("low"), size = arguments.cell("size");
    for (int a = 0; a < 3; ++a) change.low[a] = low[a], change.size[a] = size[a];
    editor.world().resize_shape(change);
}

/// Whether a condition holds for a cell of a box.
template <class F>
bool anyOf(const Cells& box, F&& condition) {
    for (int z = 0; z < box.size.z; ++z)
        for (int y = 0; y < box.size.y; ++y)
            for (int x = 0; x < box.size.x; ++x)
                if (condition(box.low + glm::ivec3(x, y, z))) return true;
    return false;
}

/// Repeats or leaves out cells until the grid has a size.
void scale(Editor& editor, const Arguments& arguments) {
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    const Cells grid = gridOf(editor.world(), shape), to{grid.low, arguments.cell("size")};
    if (to.count() > kMaxCells) arguments.refuse("size", "fewer cells in all");
    const std::vector<uint8_t> voxels = readCells(editor.world(), shape, grid);
    const CellSet places{shape, grid.low, grid.size, {}};
    const auto scaled = [&](glm::ivec3 cell, uint8_t) {
        if (!to.contains(cell)) return uint8_t(0);
        for (int a = 0; a < 3; ++a)
            cell[a] = grid.low[a] + (2 * (cell[a] - grid.low[a]) + 1) * grid.size[a] / (2 * to.size[a]);
        return voxels[places.at(cell)];
    };
    if (!anyOf(to, [&](glm::ivec3 cell) { return scaled(cell, 0) != 0; }))
        arguments.refuse("size", "one that leaves a voxel, found only cells that are empty");
    CellWriter writer(editor.world(), shape);
    writer.makeRoom(to);
    writer.write(joined(grid, to), scaled);
    editor.document().applyNow();
    rubble_resize change{};
    change.shape = shape;
    for (int a = 0; a < 3; ++a) change.low[a] = to.low[a], change.size[a] = to.size[a];
    editor.world().resize_shape(change);
}

/// Erases the voxels of which all that is within `thickness` cells along the axes is full.
void hollow(Editor& editor, const Arguments& arguments) {
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    const int thickness = arguments.whole("thickness");
    const Cells grid = gridOf(editor.world(), shape);
    const std::vector<uint8_t> voxels = readCells(editor.world(), shape, grid);
    const CellSet places{shape, grid.low, grid.size, {}};
    CellWriter writer(editor.world(), shape);
    writer.write(grid, [&](glm::ivec3 cell, uint8_t before) {
        for (int axis = 0; axis < 3; ++axis)
            for (int d = -thickness; d <= thickness; ++d) {
                glm::ivec3 near = cell;
                near[axis] += d;
                if (!grid.contains(near) || !voxels[places.at(near)]) return before;
            }
        return uint8_t(0);
    });
}

void flip(Editor& editor, const Arguments& arguments) {
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    const int axis = arguments.choice("axis");
    const Cells grid = gridOf(editor.world(), shape);
    const std::vector<uint8_t> voxels = readCells(editor.world(), shape, grid);
    const CellSet places{shape, grid.low, grid.size, {}};
    CellWriter writer(editor.world(), shape);
    writer.write(grid, [&](glm::ivec3 cell, uint8_t) {
        cell[axis] = grid.size[axis] - 1 - cell[axis];
        return voxels[places.at(cell)];
    });
}

void replaceIndex(Editor& editor, const Arguments& arguments) {
    const auto from = uint8_t(arguments.whole("from")), to = uint8_t(arguments.whole("to"));
    forEachShape(editor, arguments, [&](rubble_shape shape) {
        CellWriter(editor.world(), shape).write(gridOf(editor.world(), shape), [=](glm::ivec3, uint8_t before) {
            return before == from ? to : before;
        });
    });
}

Parameter cells(std::string_view name, std::string_view help, double low) {
    return {name, Type::Cell, help, kRequired, low, 4096};
}

}  // namespace

std::vector<Command> shapeCommands() {
    const auto index = [](std::string_view name, std::string_view help) {
        return Parameter{name, Type::Whole, help, kRequired, 1, 255};
    };
    return {
        {"trim", "shapes", Kind::Edit, "Shrinks the grid to its voxels.", {kShapes}, trim, "trim ball"},
        {"resize",
         "shapes",
         Kind::Edit,
         "Gives the grid another box of cells; what is outside is erased.",
         {cells("low", "its first cell, in present cells", -4096), cells("size", "cells along each axis", 1), kShape},
         resize,
         "resize -1,0,-1 10,9,10 crate"},
        {"scale",
         "shapes",
         Kind::Edit,
         "Makes a shape larger or smaller: cells are repeated or left out until there are so many.",
         {cells("size", "cells along each axis", 1), kShape},
         scale,
         "scale 16,8,4 crate"},
        {"hollow",
         "shapes",
         Kind::Edit,
         "Erases the inside and leaves a shell.",
         {{"thickness", Type::Whole, "of the shell, in cells", "1", 1, 64}, kShape},
         hollow,
         "hollow 2 crate"},
        {"flip",
         "shapes",
         Kind::Edit,
         "Mirrors the voxels about the middle of the grid.",
         {kAxis, kShape},
         flip,
         "flip y post"},
        {"replace",
         "shapes",
         Kind::Edit,
         "Gives all voxels of one entry of the palette another.",
         {index("from", "the entry that they have"), index("to", "the entry that they get"), kShapes},
         replaceIndex,
         "replace 5 6 crate"},
    };
}

}  // namespace editor
