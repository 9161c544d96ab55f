#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/materials.h"

namespace rubble::abi {
namespace {

/// Which entries of which shape a host means.
struct PaletteRange {
    uint32_t first = 1, count = 0, entrySize = 0;
    bool all = false;
};

PaletteRange readRange(const rubble_palette_range& given, uint32_t knownFlags) {
    PaletteRange out;
    out.all = readFlags(given.flags, knownFlags, "range->flags") & RUBBLE_PALETTE_ALL_EQUAL;
    out.first = uint32_t(readOrDefault(given.first, {1, 255}, 1, "range->first"));
    out.count = uint32_t(readInRange(given.count, {1.0, 256.0 - out.first}, "range->count"));
    out.entrySize = readRowSize<rubble_palette_entry>(given.entry_size, "range->entry_size");
    return out;
}

PaletteEntry readEntry(const HostedWorld& hosted, const rubble_palette_entry& given) {
    PaletteEntry out;
    readReserved(given.reserved, "reserved");
    out.red = given.color[0], out.green = given.color[1], out.blue = given.color[2];
    out.opacity = given.opacity;
    out.roughness = given.roughness;
    out.metallic = given.metallic;
    out.reflectivity = given.reflectivity;
    out.material = given.material;
    out.emission = float(readInRange(given.emission, ranges::kEmission, "emission"));
    const World& world = hosted.loop.world();
    const auto group =
        readOptionalHandle<HandleType::LightGroup>(world.lightGroups(), given.light_group, "light_group");
    if (group) out.lightGroup = group.slot() + 1;
    if (given.material >= world.materials().materials.size() && given.material >= waitingMaterials(hosted))
        refuse(RUBBLE_ERROR_ARGUMENT, "material is {}, expected 0 to {}", given.material, waitingMaterials(hosted) - 1);
    return out;
}

rubble_palette_entry entryRow(const World& world, const PaletteEntry& entry) {
    rubble_palette_entry out = {};
    out.color[0] = entry.red, out.color[1] = entry.green, out.color[2] = entry.blue;
    out.opacity = entry.opacity;
    out.roughness = entry.roughness;
    out.metallic = entry.metallic;
    out.reflectivity = entry.reflectivity;
    out.material = entry.material;
    out.emission = double(entry.emission);
    if (entry.lightGroup) out.light_group = world.lightGroups().handleAt(entry.lightGroup - 1).bits;
    return out;
}

rubble_result setPalette(rubble_world world, const rubble_palette_range* range, const rubble_palette_entry* entries) {
    return inWorld("set_palette", world, [&](HostedWorld& hosted) {
        const rubble_palette_range given = readStruct(range, "range");
        if (isRefused() || !isGiven(entries, "entries")) return;
        const PaletteRange rows = readRange(given, RUBBLE_PALETTE_ALL_EQUAL);
        SetPaletteEdit edit;
        edit.shape = readLiveHandle<HandleType::Shape>(hosted.loop.world().shapes(), given.shape, "range->shape");
        edit.all = rows.all;
        edit.first = uint8_t(rows.first);
        const auto* from = reinterpret_cast<const char*>(entries);
        for (uint32_t i = 0; i < rows.count && !isRefused(); ++i) {
            const char* row = from + size_t(i) * rows.entrySize;
            edit.entries.push_back(readEntry(hosted, copyStruct<rubble_palette_entry>(row, rows.entrySize)));
            if (isRefused()) Call::current().locate(fmt::format("entries[{}].", i));
        }
        push(hosted, std::move(edit));
    });
}

rubble_result getPalette(rubble_world world, const rubble_palette_range* range, rubble_palette_entry* out) {
    return inWorld("get_palette", world, [&](const HostedWorld& hosted) {
        const rubble_palette_range given = readStruct(range, "range");
        if (isRefused() || !isGiven(out, "out")) return;
        const PaletteRange rows = readRange(given, 0);
        const World& from = hosted.loop.world();
        const Shape* shape = findLive<HandleType::Shape>(from.shapes(), given.shape, "range->shape");
        if (isRefused()) return;
        auto* to = reinterpret_cast<char*>(out);
        for (uint32_t i = 0; i < rows.count; ++i)
            writeRow(to + size_t(i) * rows.entrySize, entryRow(from, (*shape->palette)[rows.first + i]),
                     rows.entrySize);
    });
}

}  // namespace

void setPaletteFunctions(rubble_api& api) {
    api.set_palette = setPalette;
    api.get_palette = getPalette;
}

}  // namespace rubble::abi
