#include "runtime/world/state/world_data.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/core/unit_length.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/state/fires.h"

namespace rubble {

WorldData::WorldData(uint8_t worldId, uint32_t firstGeneration) : id(worldId) {
    forEachKind([&](auto& map) { map = std::decay_t<decltype(map)>(worldId, firstGeneration); }, *this);
    materials = defaultMaterials();
    wire = materials.find("wire");
}

void WorldData::clear() {
    forEachKind([](auto& map) { map.clear(); }, *this);
    stress.reset();
    jointIndex.clear();
    noteOf.clear();
    fire = {};
    shapeBounds.clear();
    triggerBounds.clear();
    movedBodies.clear();
    leftBounds.clear();
    debris.clear();
    unsettled.clear();
    pendingSplits.clear();
    step = imported = removed = 0;
    made = {};
    flickeringGroups = 0;
    levelReplaced = true;
}

void WorldData::rebuildIndexes() {
    wire = materials.find("wire");
    joints.forEach([&](JointHandle handle, const Joint& joint) { jointIndex.add(handle, joint); });
    notes.forEach([&](NoteHandle handle, const Note& note) { noteOf[bitsOf(note.object)] = handle; });
    shapes.forEach([&](ShapeHandle handle, const Shape&) { updateShapeBounds(handle); });
    bodies.forEach([&](BodyHandle handle, const Body&) { updateDebris(handle); });
    groups.forEach([&](LightGroupHandle, const LightGroup& group) { flickeringGroups += group.failingSince != 0; });
    indexTriggers();
    restartStress();
}

/// All free bodies are tested against triggers in the next step.
void WorldData::indexTriggers() {
    if (!triggers.size()) return;
    triggers.forEach(
        [&](TriggerHandle handle, const Trigger& trigger) { triggerBounds.update(handle.slot(), trigger.bounds()); });
    bodies.forEach([&](BodyHandle handle, const Body& body) {
        if (!body.isStatic) movedBodies.push_back(handle);
    });
}

void WorldData::setSettings(const WorldSettings& to) {
    const bool stressChanged = !(to.stress == settings.stress);
    settings = to;
    if (stressChanged) restartStress();
    bodies.forEach([&](BodyHandle handle, const Body&) { updateDebris(handle); });
}

void WorldData::setEnvironment(Environment to) {
    to.sunDirection = glm::length(to.sunDirection) > 0.0f ? unitLength(to.sunDirection) : glm::vec3(0.0f, 1.0f, 0.0f);
    swapEnvironment(to);
}

Environment WorldData::swapEnvironment(const Environment& to) {
    if (stress && to.gravity != environment.gravity) stress->restartAll();
    return std::exchange(environment, to);
}

void WorldData::updateShapeBounds(ShapeHandle handle) {
    shapeBounds.update(handle.slot(), gridBounds(*this, handle));
}

void WorldData::updateDebris(BodyHandle handle) {
    checkBounds(handle);
    const Body* body = bodies.find(handle);
    uint64_t voxels = 0;
    bool isPiece = body && !body->isStatic && !body->shapes.empty();
    for (size_t i = 0; isPiece && i < body->shapes.size(); ++i) {  // several: a SplitShapeEdit has divided it
        const Shape* shape = shapes.find(body->shapes[i]);
        isPiece = shape && shape->isPiece;
        if (isPiece) voxels += shape->grid.voxelCount();
    }
    if (!isPiece || voxels > settings.debris.largestPiece) return debris.remove(handle);
    const RestState rest = body->settled ? RestState::Settled : body->asleep ? RestState::Asleep : RestState::Awake;
    debris.set({handle, rest, voxels, body->createdStep, body->restingSince});
}

void WorldData::setBounds(const BoundsSettings& to) {
    settings.bounds = to;
    bodies.forEach([&](BodyHandle handle, const Body&) { checkBounds(handle); });
}

bool WorldData::isOutside(BodyHandle handle) const {
    const WorldBox box = boundsInUse();
    const Body* body = bodies.find(handle);
    if (settings.bounds.rule == BoundsRule::Keep || box.low == box.high || !body || body->isStatic) return false;
    return !body->shapes.empty() && std::none_of(body->shapes.begin(), body->shapes.end(), [&](ShapeHandle shape) {
        return gridBounds(*this, shape).overlaps(box);
    });
}

void WorldData::checkBounds(BodyHandle body) {
    if (isOutside(body)) leftBounds.push_back(body);
}

JointHandle WorldData::addJoint(Joint joint) {
    const JointHandle handle = joints.insert(std::move(joint));
    jointIndex.add(handle, joints.at(handle));
    return handle;
}

const Note* WorldData::findNote(uint64_t object) const {
    if (noteOf.empty()) return nullptr;
    const auto found = noteOf.find(object);
    return found == noteOf.end() ? nullptr : notes.find(found->second);
}

NoteHandle WorldData::addNote(Note note) {
    const uint64_t object = bitsOf(note.object);
    return noteOf[object] = notes.insert(std::move(note));
}

void WorldData::restartStress() {
    stress.reset();
    if (!settings.stress.on) return;
    stress.emplace();
    shapes.forEach([&](ShapeHandle handle, const Shape&) { addStress(handle); });
}

void WorldData::addStress(ShapeHandle handle) {
    const Shape& shape = shapes.at(handle);
    if (!shape.loadBearing || !bodies.at(shape.body).isStatic) return;
    if (shape.grid.brickCount() > settings.stress.largestShape) {
        logWarning("stress: shape \"" + shape.name + "\" has " + std::to_string(shape.grid.brickCount()) +
                   " bricks and is not analysed: it never breaks under its load. To include it, raise the "
                   "setting largest_stressed, which is " +
                   std::to_string(settings.stress.largestShape));
        return;
    }
    std::vector<glm::ivec3> bricks;
    shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) { bricks.push_back(brick); });
    WorldStress::Entry& entry = stress->add(handle);
    entry.analysis.markChanged(bricks);
    for (const HeatField& field : fire.fields) {
        if (field.shape != handle) continue;
        for (const HotBrick& hot : field.bricks)
            entry.weak.push_back(
                {hot.brick, quantizedStrength(int(256.0 * remainingStrength(*this, handle, hot.brick)))});
    }
}

bool WorldData::isBusy() const {
    return hasDebrisWork() || flickeringGroups || fire.isActive() || (stress && stress->isBusy()) ||
           !movedBodies.empty() || !leftBounds.empty() || !pendingSplits.empty() || !jointIndex.winding().empty() ||
           !jointIndex.turning().empty();
}

bool WorldData::hasDebrisWork() const {
    const DebrisSettings& limits = settings.debris;
    return !unsettled.empty() || debris.awakeCount() > limits.awakeBodies || debris.count() > limits.bodies ||
           debris.voxels() > limits.voxels ||
           (step >= limits.settleSteps && debris.asleepSince(step - limits.settleSteps));
}

}  // namespace rubble
