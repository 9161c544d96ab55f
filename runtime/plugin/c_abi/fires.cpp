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
    return pushEdit("heat", world, edit, "heat", readHeat);
}
rubble_result extinguish(rubble_world world, const rubble_extinguish* edit) {
    return pushEdit("extinguish", world, edit, "extinguish", readExtinguish);
}

WorldBox readBox(const double* low, const double* high) {
    const WorldBox box{readVectorAt(low, "low"), readVectorAt(high, "high")};
    for (int a = 0; a < 3; ++a)
        if (box.low[a] > box.high[a])
            refuse(RUBBLE_ERROR_ARGUMENT, "low[{}] is {}, expected at most high[{}], {}", a, box.low[a], a,
                   box.high[a]);
    return box;
}

rubble_result removeFires(rubble_world world, const double low[3], const double high[3]) {
    return inWorld("remove_fires", world, [&](HostedWorld& hosted) {
        const WorldBox box = readBox(low, high);
        push(hosted, RemoveFiresEdit{box.low, box.high});
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

rubble_result findClosestFire(rubble_world world, const double position[3], double maxDistance, rubble_fire* out) {
    return inWorld("find_closest_fire", world, [&](const HostedWorld& hosted) {
        if (!isGiven(out, "out")) return;
        const glm::dvec3 from = readVectorAt(position, "position");
        double best = readInRange(maxDistance, ranges::kDistance, "max_distance");
        if (isRefused()) return;
        rubble_fire closest = {};
        for (const Fire& fire : findFires(hosted.loop.world())) {
            const double distance = glm::distance(fire.position, from);
            if (distance > best || (distance == best && closest.shape)) continue;
            best = distance;
            closest = fireRow(fire);
        }
        writeRow(out, closest, kFirstSize<rubble_fire>);
    });
}

rubble_result countFires(rubble_world world, const double low[3], const double high[3], uint32_t* count) {
    return inWorld("count_fires", world, [&](const HostedWorld& hosted) {
        if (!isGiven(count, "count")) return;
        *count = 0;
        const WorldBox box = readBox(low, high);
        if (isRefused()) return;
        for (const Fire& fire : findFires(hosted.loop.world())) *count += box.overlaps({fire.position, fire.position});
    });
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
    api.find_closest_fire = findClosestFire;
    api.count_fires = countFires;
}

}  // namespace rubble::abi
