#include "runtime/world/stages/light_group_stage.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/core/random.h"
#include "runtime/world/state/power_supply.h"

namespace rubble {
namespace {

/// The palette with the entries of one group dark; null if they are dark already.
PaletteRef darkened(const Palette& palette, uint32_t group) {
    const auto shines = [&](const PaletteEntry& entry) { return entry.lightGroup == group && entry.emission > 0.0f; };
    if (std::none_of(palette.begin(), palette.end(), shines)) return nullptr;
    auto out = std::make_shared<Palette>(palette);
    for (PaletteEntry& entry : *out)
        if (shines(entry)) entry.emission = 0.0f;
    return out;
}

/// Follows the wire only if the supply's shape lost wire or a piece in this step.
bool lostPower(const EditContext& context, LightGroupHandle handle, const LightGroup& group) {
    return group.supply && context.cutWires.contains(group.supply.slot()) && !isPowered(context.world, handle, group);
}

void darkenGroup(EditContext& context, LightGroupHandle group) {
    context.world.lights.forEach([&](LightHandle handle, Light& light) {
        if (light.group != group || !light.enabled) return;
        light.enabled = false;
        std::vector<LightHandle>& lights = context.changes.lights;
        if (std::find(lights.begin(), lights.end(), handle) == lights.end()) lights.push_back(handle);
    });
    std::vector<std::pair<PaletteRef, PaletteRef>> seen;  // shapes that share a palette share the dark one
    context.world.shapes.forEach([&](ShapeHandle handle, Shape& shape) {
        auto known =
            std::find_if(seen.begin(), seen.end(), [&](const auto& pair) { return pair.first == shape.palette; });
        if (known == seen.end())
            known = seen.insert(seen.end(), {shape.palette, darkened(*shape.palette, group.slot() + 1)});
        if (!known->second) return;
        shape.palette = known->second;
        std::vector<ShapeHandle>& palettes = context.changes.palettes;
        if (std::find(palettes.begin(), palettes.end(), handle) == palettes.end()) palettes.push_back(handle);
    });
}

void turnOff(EditContext& context, LightGroupHandle handle, LightGroup& group) {
    --context.world.flickeringGroups;
    group.failingSince = 0;
    group.dark = false;
    group.out = true;
    context.changes.groups.push_back(handle);
    context.changes.groupsOut.push_back(handle);
    darkenGroup(context, handle);
}

void updateFlicker(EditContext& context, LightGroupHandle handle, LightGroup& group) {
    constexpr uint64_t kSteps = 3;  ///< for which it stays on or off
    const bool isDark = hashCell(int(handle.slot()), int(context.changes.step / kSteps), 0) & 1;
    context.changes.groups.push_back(handle);
    if (std::exchange(group.dark, isDark) == isDark) return;
    context.world.lights.forEach([&](LightHandle light, const Light& each) {
        if (each.group == handle) context.changes.lights.push_back(light);
    });
}

/// Lists all that shines with a group.
void listGroup(EditContext& context, LightGroupHandle handle) {
    context.changes.groups.push_back(handle);
    context.world.lights.forEach([&](LightHandle light, const Light& each) {
        if (each.group == handle) context.changes.lights.push_back(light);
    });
    const Palette* last = nullptr;  // shapes that share one follow each other
    bool isIn = false;
    context.world.shapes.forEach([&](ShapeHandle shape, const Shape& each) {
        if (each.palette.get() != last)
            last = each.palette.get(), isIn = std::any_of(last->begin(), last->end(), [&](const PaletteEntry& entry) {
                                           return entry.lightGroup == handle.slot() + 1;
                                       });
        if (isIn) context.listPalette(shape);
    });
}

}  // namespace

void countMade(EditContext& context, const Palette& palette, const EntryCounts& made) {
    for (size_t i = 1; i < made.size(); ++i) {
        if (!made[i] || !palette[i].lightGroup) continue;
        const LightGroupHandle handle = context.world.groups.handleAt(palette[i].lightGroup - 1);
        if (!handle) continue;
        uint64_t& removed = context.removedByGroup[handle.slot()];
        const uint64_t again = std::min(made[i], removed);
        removed -= again;
        context.world.groups.at(handle).initialVoxels += made[i] - again;
        context.changes.groups.push_back(handle);
    }
}

void moveSupplies(EditContext& context, ShapeHandle from, ShapeHandle into, glm::ivec3 offset) {
    const bool isCut = context.cutWires.contains(from.slot());
    context.world.groups.forEach([&](LightGroupHandle handle, LightGroup& group) {
        if (group.supply != from) return;
        group.supply = into;
        group.supplyShape = context.world.shapes.at(into).name;
        group.supplyCell = glm::clamp(group.supplyCell + offset, glm::ivec3(-kMaxGridSize), glm::ivec3(kMaxGridSize));
        context.changes.groups.push_back(handle);
        if (isCut) context.cutWires.insert(into.slot());
    });
}

void apply(EditContext& context, const CreateLightGroupEdit& edit) {
    LightGroup group{.name = edit.group.name, .threshold = edit.group.threshold};
    group.flickerSteps = edit.group.flickerSteps;
    context.changes.groups.push_back(context.make(context.world.groups, std::move(group)));
    context.removedByGroup.resize(context.world.groups.slotCount());
}

void apply(EditContext& context, const SetLightGroupEdit& edit) {
    LightGroup* group = context.world.groups.find(edit.group);
    if (!group) return context.warnStale("set_light_group: the handle of its group is stale; nothing was changed");
    const Shape* supply = edit.setsSupply ? context.world.shapes.find(edit.supply) : nullptr;
    if (edit.setsSupply && edit.supply && !supply)
        return context.warnStale("set_light_group: the handle of its supply is stale; nothing was changed");
    context.changes.groups.push_back(edit.group);
    if (edit.setsThreshold) group->threshold = edit.threshold;
    if (edit.setsSupply) {
        group->supply = edit.supply;
        group->supplyShape = supply ? supply->name : "";
        group->supplyCell = edit.supplyCell;
        if (supply) context.cutWires.insert(edit.supply.slot());  // whether wire leads there is looked up
    }
    if (edit.switches && std::exchange(group->off, !edit.on) == edit.on) listGroup(context, edit.group);
}

void forgetLostVoxels(EditContext& context) {
    context.world.groups.forEach([&](LightGroupHandle handle, LightGroup& group) {
        if (handle.slot() >= context.removedByGroup.size() || !context.removedByGroup[handle.slot()]) return;
        group.initialVoxels -= std::min(group.initialVoxels, context.removedByGroup[handle.slot()]);
        context.changes.groups.push_back(handle);
    });
}

void updateLightGroups(EditContext& context) {
    context.world.groups.forEach([&](LightGroupHandle handle, LightGroup& group) {
        const uint64_t removed =
            handle.slot() < context.removedByGroup.size() ? context.removedByGroup[handle.slot()] : 0;
        group.removedVoxels += removed;
        if (removed) context.changes.groups.push_back(handle);
        if (group.out) return;
        const bool isBroken = removed && float(group.removedVoxels) / float(group.initialVoxels) >= group.threshold;
        if (!group.failingSince && (isBroken || lostPower(context, handle, group))) {
            group.failingSince = context.changes.step;
            ++context.world.flickeringGroups;
        }
        if (group.failingSince && context.changes.step >= group.failingSince + group.flickerSteps)
            turnOff(context, handle, group);
        else if (group.failingSince)
            updateFlicker(context, handle, group);
    });
}

}  // namespace rubble
