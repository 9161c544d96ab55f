#include "runtime/world/stages/edit_context.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/world/edits/edit_error.h"
#include "runtime/world/objects/body_mass.h"
#include "runtime/world/objects/transforms.h"

namespace rubble {

EditContext::EditContext(WorldData& data, FrameChanges& journal)
    : world(data), changes(journal), removedByGroup(data.groups.slotCount()) {}

void EditContext::refuse(const std::string& reason) {
    refuse(edit ? edit->made : AnyHandle{}, edit ? editName(*edit) : "", reason);
}

void EditContext::refuse(AnyHandle made, const char* name, const std::string& reason) {
    logWarning(std::string(name) + ": " + reason + "; nothing was changed");
    if (!made) return;
    withMapOf(static_cast<WorldObjects&>(world), made, [](auto& map, auto handle) { map.release(handle); });
    changes.refused.push_back({made, std::string(name) + ": " + reason});
}

ShapeEditState& EditContext::editState(ShapeHandle shape) {
    ShapeEditState& out = editStates[shape.slot()];
    if (out.shape != shape) out = {.shape = shape};  // the slot may have been another shape's in this step
    return out;
}

void EditContext::recordMotion(BodyHandle handle) {
    const Body& body = world.bodies.at(handle);
    if (body.isStatic || motions.contains(handle.slot())) return;
    const glm::dvec3 center = body.pose.transformPoint(bodyMass(world, handle).center);
    motions[handle.slot()] = {handle, center, body.velocity, body.angularVelocity};
}

void EditContext::recordCarved(ShapeHandle handle, const CarveResult& carved) {
    Shape& shape = world.shapes.at(handle);
    shape.moments -= carved.moments;
    if (carved.voxels) {
        const glm::dvec3 center = massProperties(carved.moments, shape.voxelSize).center;
        const double radius = 0.5 * shape.voxelSize * std::cbrt(double(carved.voxels));
        recordRemoved(
            handle, carved.removed,
            {shapeToWorld(world, handle).transformPoint(center), radius, world.bodies.at(shape.body).velocity});
    }
    ShapeEditState& each = editState(handle);
    each.lost = joined(each.lost, carved.cells);
    for (const glm::ivec3 brick : carved.bricks) each.carved.insert(brick);
}

void EditContext::recordRemoved(ShapeHandle handle, const std::array<uint64_t, 256>& removed,
                                const DustSource& source) {
    const Palette& palette = *world.shapes.at(handle).palette;
    for (size_t i = 1; i < 256; ++i) {
        if (!removed[i]) continue;
        const PaletteEntry& entry = palette[i];
        const std::array<uint8_t, 3> color = {entry.red, entry.green, entry.blue};
        changes.removed.push_back({handle, uint8_t(i), entry.material, color, removed[i]});
        changes.dust.push_back({source.position, source.radius, source.velocity, color, entry.material, removed[i]});
        world.removed += removed[i];
        countLost(handle, entry, removed[i]);
    }
}

void EditContext::recordErased(ShapeHandle handle, const std::array<uint64_t, 256>& erased) {
    const Palette& palette = *world.shapes.at(handle).palette;
    for (size_t i = 1; i < 256; ++i) {
        if (!erased[i]) continue;
        world.imported -= erased[i];
        countLost(handle, palette[i], erased[i]);
    }
}

void EditContext::countLost(ShapeHandle handle, const PaletteEntry& entry, uint64_t count) {
    if (entry.material && entry.material == world.wire) cutWires.insert(handle.slot());
    if (entry.lightGroup && entry.lightGroup <= removedByGroup.size()) removedByGroup[entry.lightGroup - 1] += count;
}

void EditContext::listPalette(ShapeHandle shape) {
    std::vector<ShapeHandle>& palettes = changes.palettes;
    if (std::find(palettes.begin(), palettes.end(), shape) == palettes.end()) palettes.push_back(shape);
}

void EditContext::wakeBody(BodyHandle handle) {
    Body& body = world.bodies.at(handle);
    if (body.asleep || body.restingSince) changes.woken.push_back(handle);
    body.asleep = body.waitsToWake = false;
    body.restingSince = 0;
    if (std::exchange(body.settled, false)) changes.unsettled.push_back(handle);
    world.updateDebris(handle);
}

void EditContext::warnStale(ShapeHandle shape, const char* warning) const {
    if (std::find(changes.shapesDestroyed.begin(), changes.shapesDestroyed.end(), shape) ==
        changes.shapesDestroyed.end())
        logWarning(warning);
}

void EditContext::warnStale(BodyHandle body, const char* warning) const {
    if (std::find(changes.bodiesDestroyed.begin(), changes.bodiesDestroyed.end(), body) ==
        changes.bodiesDestroyed.end())
        logWarning(warning);
}

void EditContext::warnStale(const std::string& warning) const {
    if (!changes.isRestored) logWarning(warning);
}

void EditContext::markBroken(ShapeHandle handle) {
    Shape& shape = world.shapes.at(handle);
    shape.broken = true;
    if (!std::exchange(world.bodies.at(shape.body).broken, true)) changes.broken.push_back(shape.body);
}

}  // namespace rubble
