// Brushes: what is done to cells, by the form of what they cover.
#include <fmt/format.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "editor/core/cells.h"
#include "editor/core/editor.h"

namespace editor {
namespace {

enum class Operation { Add, Erase, Paint, Replace };

const Parameter kShape{"shape", Type::Objects, "the shape to draw in", "selected"};
const Parameter kOperation{"do",
                           Type::Choice,
                           "add fills empty cells, erase empties, paint recolours voxels, replace writes all",
                           "add",
                           0,
                           0,
                           "add erase paint replace"};
const Parameter kIndex{"index", Type::Whole, "entry of the palette", kDefaultEntry, 1, 255};
const Parameter kMirror{"mirror",
                        Type::Choice,
                        "the same again, mirrored about the middle of the grid along these axes",
                        "none",
                        0,
                        0,
                        "none x y z xy xz yz xyz"};

const Parameter kPattern{"pattern",
                         Type::Choice,
                         "which cells it covers: all, every other cube, or every other layer along an axis",
                         "all",
                         0,
                         0,
                         "all checker x y z"};
const Parameter kEvery{"every", Type::Whole, "cells along each side of the pattern's cubes, or of its layers",
                       "1",     1,           256};

std::vector<Parameter> withBrush(std::vector<Parameter> own) {
    own.insert(own.end(), {kOperation, kIndex, kMirror, kShape, kPattern, kEvery});
    return own;
}

Parameter cellParameter(std::string_view name, std::string_view help, std::string_view otherwise = kRequired) {
    return {name, Type::Cell, help, otherwise, -4096, 4096};
}

uint8_t changed(Operation operation, uint8_t before, uint8_t index) {
    switch (operation) {
        case Operation::Add:
            return before ? before : index;
        case Operation::Erase:
            return 0;
        case Operation::Paint:
            return before ? index : 0;
        case Operation::Replace:
            return index;
    }
    return before;
}

/// Whether a cell is in a pattern; which: of the choices of kPattern.
bool isInPattern(glm::ivec3 cell, int which, int every) {
    const auto layer = [=](int c) { return (c >= 0 ? c : c - every + 1) / every; };
    if (which == 0) return true;
    if (which == 1) return (layer(cell.x) + layer(cell.y) + layer(cell.z)) % 2 == 0;
    return layer(cell[which - 2]) % 2 == 0;
}

/// A cell seen in the mirrors of those axes whose bit is set, about the middle of the grid.
glm::ivec3 mirrored(glm::ivec3 cell, unsigned axes, const Cells& grid) {
    for (int a = 0; a < 3; ++a)
        if (axes >> a & 1) cell[a] = grid.size[a] - 1 - cell[a];
    return cell;
}

/// Draws with a brush that covers those cells of a box for which isIn() is true, and their mirror images.
void draw(Editor& editor, const Arguments& arguments, const Cells& box, const std::function<bool(glm::ivec3)>& isIn) {
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    const auto operation = Operation(arguments.choice("do"));
    const auto index = uint8_t(arguments.whole("index"));
    const Cells grid = gridOf(editor.world(), shape);
    unsigned axes = 0;
    for (const char axis : arguments.text("mirror") == "none" ? "" : arguments.text("mirror"))
        axes |= 1u << (axis - 'x');
    Cells all = box;
    for (unsigned some = 1; some < 8; ++some)
        if ((some & ~axes) == 0)
            all = joined(all, between(mirrored(box.low, some, grid), mirrored(box.low + box.size - 1, some, grid)));
    if (all.count() > kMaxCells * 8)
        throw Refused(fmt::format("expected a smaller brush, found one of {} cells", all.count()));
    const int pattern = arguments.choice("pattern"), every = arguments.whole("every");
    CellWriter writer(editor.world(), shape);
    if (operation == Operation::Add || operation == Operation::Replace) writer.makeRoom(all);
    writer.write(all, [&](glm::ivec3 cell, uint8_t before) {
        if (!isInPattern(cell, pattern, every)) return before;
        for (unsigned some = 0; some < 8; ++some)
            if ((some & ~axes) == 0 && box.contains(mirrored(cell, some, grid)) && isIn(mirrored(cell, some, grid)))
                return changed(operation, before, index);
        return before;
    });
}

void drawVoxel(Editor& editor, const Arguments& arguments) {
    const glm::ivec3 cell = arguments.cell("cell");
    draw(editor, arguments, between(cell, cell), [](glm::ivec3) { return true; });
}

void drawBox(Editor& editor, const Arguments& arguments) {
    draw(editor, arguments, between(arguments.cell("from"), arguments.cell("to")), [](glm::ivec3) { return true; });
}

void drawSphere(Editor& editor, const Arguments& arguments) {
    const glm::ivec3 center = arguments.cell("center");
    const double radius = arguments.number("radius");
    const auto reach = glm::ivec3(int(radius));
    draw(editor, arguments, between(center - reach, center + reach), [=](glm::ivec3 cell) {
        const glm::dvec3 d(cell - center);
        return glm::dot(d, d) <= radius * radius;
    });
}

void drawLine(Editor& editor, const Arguments& arguments) {
    const glm::ivec3 from = arguments.cell("from"), to = arguments.cell("to");
    const double radius = arguments.number("radius");
    const auto reach = glm::ivec3(int(radius));
    const glm::dvec3 along(to - from);
    const double length2 = std::max(glm::dot(along, along), 1e-9);
    // Of a line without thickness each step along its longest side has one cell.
    const glm::ivec3 extent = glm::abs(to - from);
    const int major = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const Cells ends = between(from, to);
    draw(editor, arguments, {ends.low - reach, ends.size + 2 * reach}, [=](glm::ivec3 cell) {
        const glm::dvec3 d(cell - from);
        if (radius > 0.0) {
            const glm::dvec3 off = d - along * glm::clamp(glm::dot(d, along) / length2, 0.0, 1.0);
            return glm::dot(off, off) <= radius * radius;
        }
        const double share = extent[major] ? d[major] / along[major] : 0.0;
        return cell == from + glm::ivec3(glm::floor(along * share + 0.5));
    });
}

/// The cells of the face of voxels of one colour that a cell belongs to, on one of its sides.
CellSet faceOf(const rubble::World& world, rubble_shape shape, glm::ivec3 start, int axis, int side) {
    const Cells grid = gridOf(world, shape);
    Cells layer = grid;
    layer.low[axis] = start[axis] + std::min(side, 0), layer.size[axis] = 2;
    const std::vector<uint8_t> voxels = readCells(world, shape, layer);
    CellSet set{shape, layer.low, layer.size, std::vector<uint8_t>(voxels.size())};
    glm::ivec3 out(0);
    out[axis] = side;
    const auto isFace = [&](glm::ivec3 cell) {
        return grid.contains(cell) && voxels[set.at(cell)] == voxels[set.at(start)] && !voxels[set.at(cell + out)];
    };
    if (!grid.contains(start) || !voxels[set.at(start)] || !isFace(start))
        throw Refused("expected a voxel with nothing on that side");
    std::vector<glm::ivec3> line{start};
    set.mask[set.at(start)] = 1;
    while (!line.empty()) {
        const glm::ivec3 cell = line.back();
        line.pop_back();
        for (int a = 0; a < 3; ++a)
            for (const int step : {-1, 1}) {
                glm::ivec3 next = cell;
                next[a] += step;
                if (a == axis || !isFace(next) || set.mask[set.at(next)]) continue;
                set.mask[set.at(next)] = 1;
                line.push_back(next);
            }
    }
    return set;
}

void drawFace(Editor& editor, const Arguments& arguments) {
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    const int which = arguments.choice("side"), axis = which / 2, side = which % 2 ? 1 : -1;
    const glm::ivec3 cell = arguments.cell("cell");
    const int depth = arguments.whole("depth");
    const CellSet face = faceOf(editor.world(), shape, cell, axis, side);
    const bool goesOut = arguments.text("do") == "add" || arguments.text("do") == "replace";
    const int first = goesOut ? 1 : 1 - depth, last = goesOut ? depth : 0;  // layers, counted along the side
    Cells box{face.low, face.size};
    const int a = cell[axis] + side * first, b = cell[axis] + side * last;
    box.low[axis] = std::min(a, b), box.size[axis] = depth;
    draw(editor, arguments, box, [&](glm::ivec3 each) {
        each[axis] = cell[axis];
        return face.mask[face.at(each)] != 0;
    });
}

void drawFlood(Editor& editor, const Arguments& arguments) {
    const rubble_shape shape = editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE});
    const CellSet all = connectedCells(editor.world(), shape, arguments.cell("cell"));
    draw(editor, arguments, {all.low, all.size}, [&](glm::ivec3 cell) { return all.mask[all.at(cell)] != 0; });
}

}  // namespace

std::vector<Command> voxelCommands() {
    return {
        {"voxel", "brushes", Kind::Edit, "Draws one cell.", withBrush({cellParameter("cell", "where")}), drawVoxel,
         "voxel 1,8,1 index=5 shape=crate"},
        {"box", "brushes", Kind::Edit, "Draws a box of cells.",
         withBrush({cellParameter("from", "one corner"), cellParameter("to", "the opposite corner")}), drawBox,
         "box -2,0,0 9,3,3 do=replace index=7 shape=crate"},
        {"sphere", "brushes", Kind::Edit, "Draws a ball of cells.",
         withBrush({cellParameter("center", "its middle"), {"radius", Type::Number, "cells", "4", 0.5, 256}}),
         drawSphere, "sphere 20,12,1 5 erase shape=wall"},
        {"line", "brushes", Kind::Edit, "Draws a line from cell to cell.",
         withBrush({cellParameter("from", "its first end"),
                    cellParameter("to", "its second end"),
                    {"radius", Type::Number, "cells; 0: one cell thick", "0", 0, 64}}),
         drawLine, "line 0,0,0 39,24,2 do=paint index=9 shape=wall"},
        {"face", "brushes", Kind::Edit, "Draws on the face of one colour that a voxel belongs to: add raises it.",
         withBrush({cellParameter("cell", "a voxel of the face"),
                    {"side", Type::Choice, "of the voxel", "+y", 0, 0, "-x +x -y +y -z +z"},
                    {"depth", Type::Whole, "cells", "1", 1, 256}}),
         drawFace, "face 1,7,1 +y 2 shape=crate"},
        {"flood", "brushes", Kind::Edit, "Draws on all cells that are joined to one and hold the same.",
         withBrush({cellParameter("cell", "where it begins")}), drawFlood, "flood 0,0,0 paint 3 shape=crate"},
    };
}

}  // namespace editor
