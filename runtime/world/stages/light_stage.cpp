#include "runtime/world/stages/light_stage.h"

#include <string>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/core/planted_fault.h"
#include "runtime/voxel/nearest_voxel.h"
#include "runtime/world/objects/transforms.h"

namespace rubble {
namespace {

/// What a light is on and is not there; null: nothing.
const char* staleHandleOf(const WorldData& world, const Light& light) {
    if (light.shape && !world.shapes.find(light.shape)) return "the handle of its shape is stale";
    return light.group && !world.groups.find(light.group) ? "the handle of its light group is stale" : nullptr;
}

/// A light as the world will hold it: one of a group that is out stays dark.
Light knownLight(const WorldData& world, Light light) {
    const LightGroup* group = world.groups.find(light.group);
    if (group && group->out) light.enabled = false;
    return light;
}

}  // namespace

void apply(EditContext& context, const SetEnvironmentEdit& edit) {
    const Environment before = context.world.environment;
    context.world.setEnvironment(edit.environment);
    context.changes.environmentChanged |= before != context.world.environment;
}

void apply(EditContext& context, const AddLightEdit& edit) {
    LightHandle& added = context.changes.lightsAdded.emplace_back();
    if (const char* stale = staleHandleOf(context.world, edit.light)) return context.refuse(stale);
    if (context.world.lights.size() >= kMaxLights)
        return context.refuse("expected less than " + std::to_string(kMaxLights) + " lights, found " +
                              std::to_string(context.world.lights.size()));
    added = context.make(context.world.lights, knownLight(context.world, edit.light));
    context.changes.lights.push_back(added);
}

void apply(EditContext& context, const SetLightEdit& edit) {
    Light* light = context.world.lights.find(edit.light);
    if (!light) return context.warnStale("set_light: the handle of its light is stale; nothing was changed");
    if (const char* stale = staleHandleOf(context.world, edit.values))
        return context.warnStale(std::string("set_light: ") + stale + "; nothing was changed");
    *light = knownLight(context.world, edit.values);
    context.changes.lights.push_back(edit.light);
}

void apply(EditContext& context, const RemoveLightEdit& edit) {
    if (!context.world.lights.erase(edit.light))
        return context.warnStale("remove_light: the handle of its light is stale; nothing was removed");
    context.changes.lights.push_back(edit.light);
}

void moveLights(EditContext& context, const ShapeSplit& split) {
    const Shape& parent = context.world.shapes.at(split.parent);
    context.world.lights.forEach([&](LightHandle handle, Light& light) {
        if (light.shape != split.parent) return;
        const glm::dvec3 pointCells = light.local.position / double(parent.voxelSize);
        double best = nearestVoxelSquared(parent.grid, pointCells);
        const size_t kParent = split.children.size();
        size_t target = kParent;
        for (size_t i = 0; i < split.children.size(); ++i) {
            const double distance = nearestVoxelSquared(context.world.shapes.at(split.children[i]).grid,
                                                        pointCells - glm::dvec3(split.parentOffset[i]));
            if (distance < best) best = distance, target = i;
        }
        if (target == kParent) return;
        light.shape = split.children[target];
        light.local.position -= glm::dvec3(split.parentOffset[target]) * double(parent.voxelSize);
        context.changes.lights.push_back(handle);
    });
}

void turnOffLightsOf(EditContext& context, ShapeHandle shape) {
    context.world.lights.forEach([&](LightHandle handle, Light& light) {
        if (light.shape != shape || isPlanted("stale-light")) return;
        light.local = lightToWorld(context.world, light);
        light.shape = {};
        light.enabled = false;
        context.changes.lights.push_back(handle);
    });
}

}  // namespace rubble
