#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

SetLightGroupEdit readChange(const World& world, const rubble_light_group_change& given) {
    const uint32_t fields =
        readFlags(given.fields, RUBBLE_GROUP_SWITCH | RUBBLE_GROUP_THRESHOLD | RUBBLE_GROUP_SUPPLY, "fields");
    readReserved(given.reserved_2, "reserved_2");
    if (fields == 0) refuse(RUBBLE_ERROR_ARGUMENT, "fields is 0, expected RUBBLE_GROUP_...: nothing would change");
    SetLightGroupEdit edit;
    edit.group = readLiveHandle<HandleType::LightGroup>(world.lightGroups(), given.group, "group");
    edit.switches = fields & RUBBLE_GROUP_SWITCH;
    if (edit.switches) edit.on = readEnum(given.on, 1, "on") == 1;
    edit.setsThreshold = fields & RUBBLE_GROUP_THRESHOLD;
    if (edit.setsThreshold) edit.threshold = float(readInRange(given.threshold, ranges::kThreshold, "threshold"));
    edit.setsSupply = fields & RUBBLE_GROUP_SUPPLY;
    if (!edit.setsSupply) return edit;
    edit.supply = readOptionalHandle<HandleType::Shape>(world.shapes(), given.supply_shape, "supply_shape");
    for (int a = 0; a < 3; ++a)
        edit.supplyCell[a] = int(readInRange(given.supply_cell[a], {-kMaxGridSize, kMaxGridSize}, "supply_cell"));
    return edit;
}

rubble_result createLightGroup(rubble_world world, const rubble_light_group_settings* settings,
                               rubble_light_group* out) {
    return pushMaker("create_light_group", world, settings, out, &WorldObjects::groups,
                     [](const World&, const rubble_light_group_settings& given) {
                         CreateLightGroupEdit edit;
                         edit.group.flickerSteps = given.flicker_steps;
                         edit.group.threshold = float(readOrDefault(given.threshold, ranges::kThreshold,
                                                                    double(edit.group.threshold), "threshold"));
                         return edit;
                     });
}

rubble_result setLightGroup(rubble_world world, const rubble_light_group_change* change) {
    return pushEdit("set_light_group", world, change, "change", readChange);
}

rubble_result getLightGroup(rubble_world world, rubble_light_group group, rubble_light_group_state* out) {
    return inWorld("get_light_group", world, [&](const HostedWorld& hosted) {
        const auto* found = findLive<HandleType::LightGroup>(hosted.loop.world().lightGroups(), group, "group");
        if (!found) return;
        rubble_light_group_state state = {};
        state.flags = (found->off ? 0 : RUBBLE_GROUP_ON) | (found->out ? RUBBLE_GROUP_OUT : 0) |
                      (found->failingSince ? RUBBLE_GROUP_FAILING : 0);
        state.voxels = found->initialVoxels;
        state.removed_voxels = found->removedVoxels;
        state.threshold = double(found->threshold);
        state.supply_shape = found->supply.bits;
        writeCell(state.supply_cell, found->supplyCell);
        writeStruct(out, state);
    });
}

}  // namespace

void setLightGroupFunctions(rubble_api& api) {
    api.create_light_group = createLightGroup;
    api.set_light_group = setLightGroup;
    api.get_light_group = getLightGroup;
}

}  // namespace rubble::abi
