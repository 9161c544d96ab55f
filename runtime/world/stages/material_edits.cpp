#include "runtime/world/stages/material_edits.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/log.h"
#include "runtime/voxel/used_entries.h"
#include "runtime/world/stages/palette_edits.h"
#include "runtime/world/stages/split_stage.h"

namespace rubble {
namespace {

using MaterialSet = std::array<bool, 256>;

/// Which rows an edit changes, but for their names, and which it renames. Rows that are new are neither: nothing is of
/// them.
struct ChangedRows {
    MaterialSet changed{}, renamed{};
};

ChangedRows replaceRows(std::vector<Material>& rows, const SetMaterialsEdit& edit) {
    ChangedRows out;
    for (size_t i = 0; i < edit.materials.size(); ++i) {
        const size_t index = edit.first + i;
        if (index == rows.size()) {
            rows.push_back(edit.materials[i]);
            continue;
        }
        Material other = edit.materials[i];
        out.renamed[index] = other.name != rows[index].name;
        other.name = rows[index].name;
        out.changed[index] = other != rows[index];
        rows[index] = edit.materials[i];
    }
    return out;
}

/// The entries of a palette that are of one of these materials.
UsedEntries entriesOf(const Palette& palette, const MaterialSet& materials) {
    UsedEntries out;
    for (size_t i = 1; i < palette.size(); ++i)
        if (materials[palette[i].material]) out.insert(i);
    return out;
}

/// The renderer looks up a palette's materials by their names when it first sees it: where a name changes it gets
/// another palette with the same entries.
void refreshPalettes(EditContext& context, const MaterialSet& renamed) {
    std::vector<std::pair<PaletteRef, PaletteRef>> seen;  // shapes that share one share the other; null: it stays
    context.world.shapes.forEach([&](ShapeHandle handle, Shape& shape) {
        auto known =
            std::find_if(seen.begin(), seen.end(), [&](const auto& pair) { return pair.first == shape.palette; });
        if (known == seen.end()) {
            const UsedEntries named = entriesOf(*shape.palette, renamed);
            known = seen.insert(
                seen.end(),
                {shape.palette, named.intersects(named) ? std::make_shared<const Palette>(*shape.palette) : nullptr});
        }
        if (!known->second) return;
        shape.palette = known->second;
        context.listPalette(handle);
    });
}

}  // namespace

void apply(EditContext& context, const SetMaterialsEdit& edit) {
    MaterialTable& table = context.world.materials;
    if (edit.first > table.materials.size())
        return logWarning("set_materials: the first row is " + std::to_string(edit.first) + ", expected at most " +
                          std::to_string(table.materials.size()) + "; nothing was changed");
    releaseFragments(context);  // they weigh what they did when they came off
    const MaterialTable before = table;
    const ChangedRows rows = replaceRows(table.materials, edit);
    if (table == before) return;
    context.changes.materialsChanged = true;
    context.world.wire = table.find("wire");
    const bool isRewired = context.world.wire != before.find("wire");
    if (std::find(rows.renamed.begin(), rows.renamed.end(), true) != rows.renamed.end())
        refreshPalettes(context, rows.renamed);
    const Palette* last = nullptr;  // shapes that share one follow each other
    UsedEntries affected;
    context.world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        if (shape.palette.get() != last) affected = entriesOf(*(last = shape.palette.get()), rows.changed);
        if (isRewired) context.cutWires.insert(handle.slot());
        if (affected.intersects(usedEntries(shape.grid))) updateMatter(context, handle);
    });
}

}  // namespace rubble
