#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/rows.h"

namespace rubble::abi {
namespace {

constexpr NumberRange kHostHeatRadius{1e-3, ranges::kHeatRadius.high};  // metres

HeatEdit readHeat(const World& world, const rubble_heat& given) {
    HeatEdit edit;
    edit.position = readVector(given.position, "position");
    edit.radius = readOrDefault(given.radius, kHostHeatRadius, edit.radius, "radius");
    edit.joules = readInRange(given.joules, ranges::kHeat, "joules");
    edit.ignite = readFlags(given.flags, RUBBLE_HEAT_IGNITE, "flags") & RUBBLE_HEAT_IGNITE;
    edit.shape = readOptionalHandle<HandleType::Shape>(world.shapes(), given.shape, "shape");
    return edit;
}

ExtinguishEdit readExtinguish(const World&, const rubble_extinguish& given) {
    ExtinguishEdit edit;
    edit.position = readVector(given.position, "position");
    edit.radius = readOrDefault(given.radius, kHostHeatRadius, edit.radius, "radius");
    edit.wetSeconds = readInRange(given.wet_seconds, ranges::kWetSeconds, "wet_seconds");
    return edit;
}

rubble_result heat(rubble_world world, const rubble_heat* edit) {
    return pushEdit("heat", world, edit, readHeat);
}
rubble_result extinguish(rubble_world world, const rubble_extinguish* edit) {
    return pushEdit("extinguish", world, edit, readExtinguish);
}

rubble_result removeFires(rubble_world world, const double low[3], const double high[3]) {
    return inWorld("remove_fires", world, [&](HostedWorld& hosted) {
        const RemoveFiresEdit edit{readVectorAt(low, "low"), readVectorAt(high, "high")};
        for (int a = 0; a < 3; ++a)
            if (edit.low[a] > edit.high[a])
                refuse(RUBBLE_ERROR_ARGUMENT, "low[{}] is {}, expected at most high[{}], {}", a, edit.low[a], a,
                       edit.high[a]);
        push(hosted, edit);
    });
}

rubble_fire fireRow(const Fire& fire) {
    rubble_fire row = {};
    row.shape = fire.shape.bits;
    writeVector(row.position, fire.position);
    row.radius = fire.radius;
    row.intensity = double(fire.intensity);
    return row;
}

rubble_result getFires(rubble_world world, rubble_fire* out, uint32_t capacity, uint32_t* count) {
    return listRows("get_fires", world, out, capacity, count);
}

}  // namespace

void writeRows(const HostedWorld& hosted, RowWriter<rubble_fire>& rows) {
    for (const Fire& fire : findFires(hosted.loop.world())) rows.add([&] { return fireRow(fire); });
}

void setFireFunctions(rubble_api& api) {
    api.heat = heat;
    api.extinguish = extinguish;
    api.remove_fires = removeFires;
    api.get_fires = getFires;
}

}  // namespace rubble::abi
