// What is done with the cells that are selected.
#include <algorithm>

#include "editor/core/cells.h"
#include "editor/core/editor.h"

namespace editor {
namespace {

const CellSet& selectedCells(Editor& editor) {
    const CellSet& cells = editor.selection().cells;
    if (!cells.shape) throw Refused("expected selected cells, found none: select_box or its like selects some");
    return cells;
}

void changeSelected(Editor& editor, const std::function<uint8_t(uint8_t)>& change) {
    const CellSet& cells = selectedCells(editor);
    CellWriter writer(editor.world(), cells.shape);
    writer.write({cells.low, cells.size},
                 [&](glm::ivec3 cell, uint8_t before) { return cells.mask[cells.at(cell)] ? change(before) : before; });
}

void copy(Editor& editor, const Arguments&) {
    const CellSet& cells = selectedCells(editor);
    Clipboard& to = editor.clipboard();
    to.size = cells.size;
    to.voxels = readCells(editor.world(), cells.shape, {cells.low, cells.size});
    std::transform(to.voxels.begin(), to.voxels.end(), cells.mask.begin(), to.voxels.begin(),
                   [](uint8_t voxel, uint8_t isIn) { return isIn ? voxel : uint8_t(0); });
}

void eraseSelected(Editor& editor, const Arguments&) {
    changeSelected(editor, [](uint8_t) { return uint8_t(0); });
}

void cut(Editor& editor, const Arguments& arguments) {
    copy(editor, arguments);
    eraseSelected(editor, arguments);
}

void paintSelected(Editor& editor, const Arguments& arguments) {
    const auto index = uint8_t(arguments.whole("index"));
    changeSelected(editor, [=](uint8_t before) { return before ? index : before; });
}

void fillSelected(Editor& editor, const Arguments& arguments) {
    const auto index = uint8_t(arguments.whole("index"));
    changeSelected(editor, [=](uint8_t) { return index; });
}

void paste(Editor& editor, const Arguments& arguments) {
    const Clipboard& from = editor.clipboard();
    if (from.voxels.empty()) throw Refused("expected cells that were copied, found none: copy some first");
    const Cells box{arguments.cell("cell"), from.size};
    CellWriter writer(editor.world(), editor.object(arguments, "shape", {RUBBLE_KIND_SHAPE}));
    writer.makeRoom(box);
    const CellSet places{1, box.low, box.size, {}};
    writer.write(box, [&](glm::ivec3 cell, uint8_t before) {
        const uint8_t voxel = from.voxels[places.at(cell)];
        return voxel ? voxel : before;
    });
}

}  // namespace

std::vector<Command> clipboardCommands() {
    const Parameter index{"index", Type::Whole, "entry of the palette", kDefaultEntry, 1, 255};
    return {
        {"copy", "cells", Kind::View, "Copies the voxels of the selected cells.", {}, copy, "copy"},
        {"cut", "cells", Kind::Edit, "Copies the voxels of the selected cells and erases them.", {}, cut, "cut"},
        {"paste",
         "cells",
         Kind::Edit,
         "Puts what was copied into a shape.",
         {{"cell", Type::Cell, "where its first corner comes", kRequired, -4096, 4096},
          {"shape", Type::Objects, "the shape to paste into", "selected"}},
         paste,
         "paste 6,6,6 crate"},
        {"erase_selected",
         "cells",
         Kind::Edit,
         "Erases the voxels of the selected cells.",
         {},
         eraseSelected,
         "erase_selected"},
        {"paint_selected",
         "cells",
         Kind::Edit,
         "Recolours the voxels of the selected cells.",
         {index},
         paintSelected,
         "paint_selected 4"},
        {"fill_selected",
         "cells",
         Kind::Edit,
         "Puts a voxel into each selected cell.",
         {index},
         fillSelected,
         "fill_selected 6"},
    };
}

}  // namespace editor
