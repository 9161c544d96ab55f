#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/rows.h"

namespace rubble::abi {
namespace {

GroundPolygon readOutline(const double* outline, uint32_t count) {
    GroundPolygon area;
    readInRange(count, ranges::kOutlinePoints, "outline_count");
    isGiven(outline, "outline");
    if (isRefused()) return area;
    for (uint32_t i = 0; i < count; ++i) {
        const double corner[3] = {outline[2 * i], 0.0, outline[2 * i + 1]};
        const glm::dvec3 read = readVector(corner, "outline");
        area.push_back({read.x, read.z});
    }
    return area;
}

AddWaterEdit readWater(const World&, const rubble_water_settings& given) {
    Water water;
    water.outline = readOutline(given.outline, given.outline_count);
    water.surface = readOrDefault(given.surface_height, ranges::kWaterSurface, 0.0, "surface_height");
    water.depth = readOrDefault(given.depth, ranges::kWaterDepth, water.depth, "depth");
    water.density = readOrDefault(given.density, ranges::kWaterDensity, water.density, "density");
    water.linearDrag = readOrDefault(given.linear_drag, ranges::kWaterDrag, water.linearDrag, "linear_drag");
    water.angularDrag = readOrDefault(given.angular_drag, ranges::kWaterDrag, water.angularDrag, "angular_drag");
    water.flow = readVector(given.flow, "flow", ranges::kWaterFlow);
    return {water};
}

AddTriggerEdit readTrigger(const World&, const rubble_trigger_settings& given) {
    Trigger trigger;
    trigger.kind = TriggerKind(readEnum(given.kind, RUBBLE_TRIGGER_POLYGON, "kind"));
    trigger.pose = {readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    trigger.radius = readOrDefault(given.radius, ranges::kTriggerSize, trigger.radius, "radius");
    for (int i = 0; i < 3; ++i)
        trigger.halfSize[i] = readOrDefault(given.half_size[i], ranges::kTriggerSize, trigger.halfSize[i], "half_size");
    trigger.height = readOrDefault(given.height, ranges::kTriggerSize, trigger.height, "height");
    if (trigger.kind == TriggerKind::Polygon) trigger.outline = readOutline(given.outline, given.outline_count);
    trigger.layerMask = readLayers(given.layer_mask, 255, "layer_mask");
    return {trigger};
}

rubble_result addWater(rubble_world world, const rubble_water_settings* water) {
    return pushEdit("add_water", world, water, "water", readWater);
}
rubble_result createWater(rubble_world world, const rubble_water_settings* water, rubble_water* out) {
    return pushMaker("create_water", world, water, out, &WorldObjects::waters, readWater);
}
rubble_result removeWater(rubble_world world, rubble_water water) {
    return removeOne<RemoveWaterEdit, HandleType::Water>("remove_water", world, water, "water", &World::waters);
}
rubble_result getWaters(rubble_world world, rubble_water* out, uint32_t capacity, uint32_t* count) {
    return listAll("get_waters", world, out, capacity, count, &World::waters);
}

rubble_result addTrigger(rubble_world world, const rubble_trigger_settings* trigger) {
    return pushEdit("add_trigger", world, trigger, "trigger", readTrigger);
}
rubble_result createTrigger(rubble_world world, const rubble_trigger_settings* trigger, rubble_trigger* out) {
    return pushMaker("create_trigger", world, trigger, out, &WorldObjects::triggers, readTrigger);
}
rubble_result removeTrigger(rubble_world world, rubble_trigger trigger) {
    return removeOne<RemoveTriggerEdit, HandleType::Trigger>("remove_trigger", world, trigger, "trigger",
                                                             &World::triggers);
}
rubble_result getTriggers(rubble_world world, rubble_trigger* out, uint32_t capacity, uint32_t* count) {
    return listAll("get_triggers", world, out, capacity, count, &World::triggers);
}

rubble_result getTriggerEvents(rubble_world world, rubble_trigger_event* out, uint32_t capacity, uint32_t* count) {
    return listRows("get_trigger_events", world, out, capacity, count);
}

rubble_result getTriggerBodies(rubble_world world, rubble_trigger trigger, rubble_body* out, uint32_t capacity,
                               uint32_t* count) {
    return listRows<rubble_body>(
        "get_trigger_bodies", world, out, capacity, count, [&](const HostedWorld& hosted, auto& rows) {
            const Trigger* found = findLive<HandleType::Trigger>(hosted.loop.world().triggers(), trigger, "trigger");
            if (!found) return;
            for (const BodyHandle body : found->inside) rows.add([&] { return body.bits; });
        });
}

}  // namespace

void writeRows(const HostedWorld& hosted, RowWriter<rubble_trigger_event>& rows) {
    for (const TriggerEvent& event : hosted.loop.changes().triggerEvents)
        rows.add([&] { return rubble_trigger_event{event.trigger.bits, event.body.bits, event.entered, 0}; });
}

void setRegionFunctions(rubble_api& api) {
    api.add_water = addWater;
    api.create_water = createWater;
    api.remove_water = removeWater;
    api.get_waters = getWaters;
    api.add_trigger = addTrigger;
    api.create_trigger = createTrigger;
    api.remove_trigger = removeTrigger;
    api.get_triggers = getTriggers;
    api.get_trigger_events = getTriggerEvents;
    api.get_trigger_bodies = getTriggerBodies;
}

}  // namespace rubble::abi
