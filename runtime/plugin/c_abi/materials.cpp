#include "runtime/plugin/c_abi/materials.h"

#include <algorithm>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/world/edits/edit_error.h"

namespace rubble::abi {
namespace {

/// Calls f(engine's, host's, name) for each pair of floats that mean the same: the one list of them for both
/// directions.
template <class Engine, class Host, class F>
void forEachNumber(Engine& m, Host& h, F&& f) {
    f(m.tensileStrength, h.tensile_strength, "tensile_strength");
    f(m.compressiveStrength, h.compressive_strength, "compressive_strength");
    f(m.shearStrength, h.shear_strength, "shear_strength");
    f(m.friction, h.friction, "friction");
    f(m.restitution, h.restitution, "restitution");
    f(m.heatCapacity, h.heat_capacity, "heat_capacity");
    f(m.ignitionTemperature, h.ignition_temperature, "ignition_temperature");
    f(m.burnTime, h.burn_time, "burn_time");
}

Material readMaterial(const rubble_material& given) {
    Material out;
    if (!isGiven(given.name, "name") || !isGiven(given.fragments, "fragments")) return out;
    out.name = given.name;
    out.fragments = given.fragments;
    out.density = given.density;
    const double hardness = readInRange(given.hardness, {RUBBLE_HARDNESS_SOFT, RUBBLE_HARDNESS_UNPHYSICAL}, "hardness");
    out.hardness = Hardness(int(hardness) - RUBBLE_HARDNESS_SOFT);
    const uint32_t tools = readFlags(
        given.tools,
        RUBBLE_BREAKS_BY_SLEDGE | RUBBLE_BREAKS_BY_TORCH | RUBBLE_BREAKS_BY_GUN | RUBBLE_BREAKS_BY_EXPLOSIVE, "tools");
    out.sledge = tools & RUBBLE_BREAKS_BY_SLEDGE;
    out.torch = tools & RUBBLE_BREAKS_BY_TORCH;
    out.gun = tools & RUBBLE_BREAKS_BY_GUN;
    out.explosive = tools & RUBBLE_BREAKS_BY_EXPLOSIVE;
    // No range is above that of strengths; what a float cannot hold is refused before it takes it.
    forEachNumber(out, given, [](float& to, double from, const char* name) {
        to = float(readInRange(from, ranges::kMaterialStrength, name));
    });
    return out;
}

rubble_material materialOf(const Material& from) {
    rubble_material out = {};
    out.name = from.name.c_str();
    out.fragments = from.fragments.c_str();
    out.hardness = uint32_t(from.hardness) + RUBBLE_HARDNESS_SOFT;
    out.density = from.density;
    out.tools = (from.sledge ? RUBBLE_BREAKS_BY_SLEDGE : 0) | (from.torch ? RUBBLE_BREAKS_BY_TORCH : 0) |
                (from.gun ? RUBBLE_BREAKS_BY_GUN : 0) | (from.explosive ? RUBBLE_BREAKS_BY_EXPLOSIVE : 0);
    forEachNumber(from, out, [](float value, double& to, const char*) { to = double(value); });
    return out;
}

rubble_result setMaterials(rubble_world world, uint32_t first, const rubble_material* materials, uint32_t count) {
    return inWorld("set_materials", world, [&](HostedWorld& hosted) {
        if (!isGiven(materials, "materials")) return;
        SetMaterialsEdit edit;
        size_t rows = hosted.loop.world().materials().materials.size();
        if (first > rows) rows = waitingMaterials(hosted);  // a look at the whole queue
        edit.first = uint8_t(readInRange(first, {1.0, double(std::min<size_t>(rows, 255))}, "first"));
        readInRange(count, {1.0, 256.0 - edit.first}, "count");
        const size_t stride = isRefused() ? 0 : materials->struct_size;  // all rows are of one size
        const auto* row = reinterpret_cast<const char*>(materials);
        for (uint32_t i = 0; i < count && !isRefused(); ++i, row += stride) {
            const std::string name = fmt::format("materials[{}]", i);
            const auto given = readStruct(reinterpret_cast<const rubble_material*>(row), name.c_str());
            if (isRefused()) break;
            edit.materials.push_back(readMaterial(given));
            if (isRefused()) Call::current().locate(name + ".");
        }
        if (!isRefused()) requireNoError(editError(edit));
        push(hosted, std::move(edit));
    });
}

rubble_result getMaterial(rubble_world world, uint32_t index, rubble_material* out) {
    return inWorld("get_material", world, [&](const HostedWorld& hosted) {
        const MaterialTable& table = hosted.loop.world().materials();
        readInRange(index, {0.0, double(table.materials.size()) - 1.0}, "index");
        if (!isRefused()) writeStruct(out, materialOf(table.materials[index]));
    });
}

rubble_result getMaterialCount(rubble_world world, uint32_t* count) {
    return inWorld("get_material_count", world, [&](const HostedWorld& hosted) {
        if (isGiven(count, "count")) *count = uint32_t(hosted.loop.world().materials().materials.size());
    });
}

rubble_result findMaterial(rubble_world world, const char* name, uint32_t* index) {
    return inWorld("find_material", world, [&](const HostedWorld& hosted) {
        if (isGiven(name, "name") && isGiven(index, "index")) *index = hosted.loop.world().materials().find(name);
    });
}

}  // namespace

size_t waitingMaterials(const HostedWorld& hosted) {
    size_t count = hosted.loop.world().materials().materials.size();
    for (const Edit& edit : hosted.loop.edits().waiting())
        if (const auto* rows = std::get_if<SetMaterialsEdit>(&edit))
            count = std::max(count, rows->first + rows->materials.size());
    return count;
}

void setMaterialFunctions(rubble_api& api) {
    api.set_materials = setMaterials;
    api.get_material = getMaterial;
    api.get_material_count = getMaterialCount;
    api.find_material = findMaterial;
}

}  // namespace rubble::abi
