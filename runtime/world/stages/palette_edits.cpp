#include "runtime/world/stages/palette_edits.h"

#include <algorithm>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/voxel/used_entries.h"
#include "runtime/world/stages/entry_counts.h"

namespace rubble {
namespace {

/// Whether voxels of an entry make a difference to the world, not to their looks alone.
bool isOtherMatter(const PaletteEntry& a, const PaletteEntry& b) {
    return a.material != b.material || a.lightGroup != b.lightGroup;
}

/// Voxels that change their light group count in the new one from the first on, and in the old one no longer.
void moveToGroups(EditContext& context, const Palette& before, const Palette& now, const EntryCounts& counts) {
    const auto groupOf = [&](const PaletteEntry& entry) {
        return entry.lightGroup ? context.world.groups.handleAt(entry.lightGroup - 1) : LightGroupHandle{};
    };
    for (size_t i = 1; i < 256; ++i) {
        if (!counts[i] || before[i].lightGroup == now[i].lightGroup) continue;
        if (const LightGroupHandle from = groupOf(before[i])) {
            LightGroup& group = context.world.groups.at(from);
            group.initialVoxels -= std::min(group.initialVoxels, counts[i]);
            context.changes.groups.push_back(from);
        }
        if (const LightGroupHandle to = groupOf(now[i])) {
            context.world.groups.at(to).initialVoxels += counts[i];
            context.changes.groups.push_back(to);
        }
    }
}

/// What weighs, holds and touches follows.
void changeMatter(EditContext& context, ShapeHandle handle, const Palette& before, const Palette& now) {
    Shape& shape = context.world.shapes.at(handle);
    const uint8_t wire = context.world.wire;
    bool isOther = false;
    usedEntries(shape.grid).forEach([&](size_t i) {
        isOther = isOther || before[i].material != now[i].material;
        if (wire && before[i].material == wire && now[i].material != wire) context.cutWires.insert(handle.slot());
        if (before[i].lightGroup != now[i].lightGroup) context.cutWires.insert(handle.slot());
    });
    if (isOther) updateMatter(context, handle);
}

void replacePalette(EditContext& context, ShapeHandle handle, const PaletteRef& now) {
    Shape& shape = context.world.shapes.at(handle);
    const PaletteRef before = std::exchange(shape.palette, now);
    context.listPalette(handle);
    if (std::equal(before->begin(), before->end(), now->begin(),
                   [](const PaletteEntry& a, const PaletteEntry& b) { return !isOtherMatter(a, b); }))
        return;
    moveToGroups(context, *before, *now, countEntries(shape.grid));
    changeMatter(context, handle, *before, *now);
}

/// A palette with the entries of an edit.
Palette withEntries(const WorldData& world, Palette palette, const SetPaletteEdit& edit) {
    for (size_t i = 0; i < edit.entries.size(); ++i) {
        PaletteEntry& entry = palette[edit.first + i] = edit.entries[i];
        const LightGroup* group =
            entry.lightGroup ? world.groups.find(world.groups.handleAt(entry.lightGroup - 1)) : nullptr;
        if (group && group->out) entry.emission = 0.0f;
    }
    return palette;
}

}  // namespace

std::string paletteError(const WorldData& world, std::span<const PaletteEntry> entries) {
    for (const PaletteEntry& entry : entries) {
        if (entry.material >= world.materials.materials.size())
            return "its palette names material " + std::to_string(entry.material) + ", the world has " +
                   std::to_string(world.materials.materials.size());
        if (entry.lightGroup > world.groups.slotCount())
            return "its palette names light group " + std::to_string(entry.lightGroup) + ", which is not there";
    }
    return "";
}

void updateMatter(EditContext& context, ShapeHandle handle) {
    Shape& shape = context.world.shapes.at(handle);
    if (!context.isNew(shape.body)) context.recordMotion(shape.body);
    shape.moments = gridMoments(shape.grid, *shape.palette, context.world.materials);
    context.editState(handle).otherMaterials = true;
    if (!context.isNew(shape.body)) context.wakeBody(shape.body);
}

void apply(EditContext& context, const SetPaletteEdit& edit) {
    const Shape* shape = context.world.shapes.find(edit.shape);
    if (!shape)
        return context.warnStale(edit.shape, "set_palette: the handle of its shape is stale; nothing was changed");
    if (const std::string error = paletteError(context.world, edit.entries); !error.empty())
        return logWarning("set_palette: " + error + "; nothing was changed");
    const PaletteRef before = shape->palette;
    const auto now = std::make_shared<const Palette>(withEntries(context.world, *before, edit));
    if (*now == *before) return;
    if (!edit.all) return replacePalette(context, edit.shape, now);
    std::vector<ShapeHandle> equal;
    const Palette* last = nullptr;  // shapes that share one follow each other
    bool isEqual = false;
    context.world.shapes.forEach([&](ShapeHandle handle, const Shape& each) {
        if (each.palette.get() != last) last = each.palette.get(), isEqual = *each.palette == *before;
        if (isEqual) equal.push_back(handle);
    });
    for (const ShapeHandle handle : equal) replacePalette(context, handle, now);
}

}  // namespace rubble
