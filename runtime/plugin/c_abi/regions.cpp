#include "runtime/plugin/c_abi/regions.h"

#include "runtime/plugin/c_abi/guard.h"

namespace rubble::abi {
namespace {

GroundPolygon readOutline(const double* outline, uint32_t count) {
    if (count < 3 || count > 10000)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "outline_count is " + std::to_string(count) + ", expected 3 to 10000"};
    requireNotNull(outline, "outline");
    GroundPolygon area;
    for (uint32_t i = 0; i < count; ++i) {
        const double corner[3] = {outline[2 * i], 0.0, outline[2 * i + 1]};
        const glm::dvec3 read = readVector(corner, "outline");
        area.push_back({read.x, read.z});
    }
    return area;
}

uint8_t readBits(uint32_t bits, uint8_t ifZero, const char* name) {
    if (bits > RUBBLE_COLLISION_NONE)
        throw ApiError{RUBBLE_ERROR_ARGUMENT,
                       std::string(name) + " is " + std::to_string(bits) + ", expected 0 to 256"};
    return bits == 0 ? ifZero : uint8_t(bits & 255);
}

SetCollisionEdit toEdit(const World& world, const rubble_collision_filter& given) {
    SetCollisionEdit edit{readHandle<HandleType::Shape>(given.shape, "shape"), readBits(given.layer, 1, "layer"),
                          readBits(given.mask, 255, "mask")};
    requireAlive(world.shapes(), edit.shape, "shape");
    return edit;
}

AddWaterEdit toEdit(const World&, const rubble_water_settings& given) {
    Water water;
    water.outline = readOutline(given.outline, given.outline_count);
    water.surface = readOrDefault(given.surface, -1e6, 1e6, 0.0, "surface");
    water.depth = readOrDefault(given.depth, 1e-3, 1e5, water.depth, "depth");
    water.density = readOrDefault(given.density, 1.0, 1e5, water.density, "density");
    water.linearDrag = readOrDefault(given.linear_drag, 0.0, 1e5, water.linearDrag, "linear_drag");
    water.angularDrag = readOrDefault(given.angular_drag, 0.0, 1e5, water.angularDrag, "angular_drag");
    water.flow = readVector(given.flow, "flow");
    return {water};
}

AddTriggerEdit toEdit(const World&, const rubble_trigger_settings& given) {
    if (given.kind > RUBBLE_TRIGGER_POLYGON)
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "kind is " + std::to_string(given.kind) + ", expected 0 to 2"};
    Trigger trigger;
    trigger.kind = TriggerKind(given.kind);
    trigger.pose = {readVector(given.position, "position"), readRotation(given.rotation, "rotation")};
    trigger.radius = readOrDefault(given.radius, 1e-3, 1e5, trigger.radius, "radius");
    const double(&half)[3] = given.half_size;
    for (int i = 0; i < 3; ++i)
        trigger.halfSize[i] = readOrDefault(half[i], 1e-3, 1e5, trigger.halfSize[i], "half_size");
    trigger.height = readOrDefault(given.height, 1e-3, 1e5, trigger.height, "height");
    if (trigger.kind == TriggerKind::Polygon) trigger.outline = readOutline(given.outline, given.outline_count);
    trigger.layers = readBits(given.layers, 255, "layers");
    return {trigger};
}

AddCharacterEdit toEdit(const World&, const rubble_character_settings& given) {
    Character c;
    c.position = readVector(given.position, "position");
    c.radius = readOrDefault(given.radius, 0.02, 10.0, c.radius, "radius");
    c.height = readOrDefault(given.height, 2.0 * c.radius, 100.0, c.height, "height");
    c.crouchedHeight =
        readOrDefault(given.crouched_height, 2.0 * c.radius, c.height, c.crouchedHeight, "crouched_height");
    c.stepHeight = readOrDefault(given.step_height, 0.0, c.height, c.stepHeight, "step_height");
    c.steepest = readOrDefault(given.steepest, 0.0, 1e3, c.steepest, "steepest");
    c.mass = readOrDefault(given.mass, 1e-3, 1e6, c.mass, "mass");
    c.walkSpeed = readOrDefault(given.walk_speed, 0.0, 100.0, c.walkSpeed, "walk_speed");
    c.jumpSpeed = readOrDefault(given.jump_speed, 0.0, 100.0, c.jumpSpeed, "jump_speed");
    c.swimSpeed = readOrDefault(given.swim_speed, 0.0, 100.0, c.swimSpeed, "swim_speed");
    c.pushForce = readOrDefault(given.push_force, 0.0, 1e9, c.pushForce, "push_force");
    if (!(c.height >= c.crouchedHeight && c.crouchedHeight >= 2.0 * c.radius && c.stepHeight <= c.height))
        throw ApiError{RUBBLE_ERROR_ARGUMENT,
                       "heights do not fit: expected height >= crouched_height >= 2 radius, and no higher steps"};
    return {c};
}

MoveCharacterEdit toEdit(const World& world, const rubble_character_move& given) {
    if (given.flags & ~uint32_t(RUBBLE_MOVE_JUMP | RUBBLE_MOVE_CROUCH))
        throw ApiError{RUBBLE_ERROR_ARGUMENT, "flags has unknown bits"};
    MoveCharacterEdit edit{readHandle<HandleType::Character>(given.character, "character"),
                           readVector(given.wish, "wish"), (given.flags & RUBBLE_MOVE_JUMP) != 0,
                           (given.flags & RUBBLE_MOVE_CROUCH) != 0};
    requireAlive(world.characters(), edit.character, "character");
    if (glm::length(edit.wish) > 1e3) throw ApiError{RUBBLE_ERROR_ARGUMENT, "wish is faster than 1 km/s"};
    return edit;
}

PlaceCharacterEdit toEdit(const World& world, const rubble_character_teleport& given) {
    PlaceCharacterEdit edit{readHandle<HandleType::Character>(given.character, "character"),
                            readVector(given.position, "position"), readVector(given.velocity, "velocity")};
    requireAlive(world.characters(), edit.character, "character");
    if (glm::length(edit.velocity) > 1e3) throw ApiError{RUBBLE_ERROR_ARGUMENT, "velocity is above 1 km/s"};
    return edit;
}

constexpr auto kToEdit = [](const World& world, const auto& given) { return toEdit(world, given); };

}  // namespace

rubble_result setCollision(rubble_world world, const rubble_collision_filter* edit) {
    return pushEdit("set_collision_filter", world, edit, kToEdit);
}
rubble_result addWater(rubble_world world, const rubble_water_settings* water) {
    return pushEdit("add_water", world, water, kToEdit);
}
rubble_result removeWater(rubble_world world, rubble_water water) {
    return removeOne<RemoveWaterEdit, HandleType::Water>("remove_water", world, water, "water", &World::waters);
}
rubble_result addTrigger(rubble_world world, const rubble_trigger_settings* trigger) {
    return pushEdit("add_trigger", world, trigger, kToEdit);
}
rubble_result removeTrigger(rubble_world world, rubble_trigger trigger) {
    return removeOne<RemoveTriggerEdit, HandleType::Trigger>("remove_trigger", world, trigger, "trigger",
                                                             &World::triggers);
}
rubble_result addCharacter(rubble_world world, const rubble_character_settings* character) {
    return pushEdit("add_character", world, character, kToEdit);
}
rubble_result removeCharacter(rubble_world world, rubble_character character) {
    return removeOne<RemoveCharacterEdit, HandleType::Character>("remove_character", world, character, "character",
                                                                 &World::characters);
}
rubble_result moveCharacter(rubble_world world, const rubble_character_move* move) {
    return pushEdit("move_character", world, move, kToEdit);
}
rubble_result teleportCharacter(rubble_world world, const rubble_character_teleport* place) {
    return pushEdit("teleport_character", world, place, kToEdit);
}

rubble_result waters(rubble_world world, rubble_water* out, uint32_t capacity, uint32_t* count) {
    return listAll("get_waters", world, out, capacity, count, &World::waters);
}
rubble_result triggers(rubble_world world, rubble_trigger* out, uint32_t capacity, uint32_t* count) {
    return listAll("get_triggers", world, out, capacity, count, &World::triggers);
}

rubble_result getCharacterStates(rubble_world world, rubble_character_state* out, uint32_t capacity, uint32_t* count) {
    return guarded("get_character_states", [&] {
        const auto hosted = Registry::instance().world(world);
        RowWriter<rubble_character_state> rows(out, capacity, count);
        hosted->loop.world().characters().forEach([&](CharacterHandle handle, const Character& character) {
            rows.add([&] {
                rubble_character_state row = {};
                row.character = handle.bits;
                writeVector(row.position, character.position);
                writeVector(row.velocity, character.velocity);
                row.ground = character.ground.bits;
                row.flags = (character.grounded ? RUBBLE_CHARACTER_GROUNDED : 0) |
                            (character.crouched ? RUBBLE_CHARACTER_CROUCHED : 0) |
                            (character.swimming ? RUBBLE_CHARACTER_SWIMMING : 0);
                return row;
            });
        });
        rows.finish();
    });
}

rubble_result triggerEvents(rubble_world world, rubble_trigger_event* out, uint32_t capacity, uint32_t* count) {
    return guarded("get_trigger_events", [&] {
        const auto hosted = Registry::instance().world(world);
        RowWriter<rubble_trigger_event> rows(out, capacity, count);
        for (const TriggerEvent& event : hosted->loop.changes().triggerEvents)
            rows.add([&] { return rubble_trigger_event{event.trigger.bits, event.body.bits, event.entered, 0}; });
        rows.finish();
    });
}

rubble_result getTriggerBodies(rubble_world world, rubble_trigger trigger, rubble_body* out, uint32_t capacity,
                               uint32_t* count) {
    return guarded("get_trigger_bodies", [&] {
        const auto hosted = Registry::instance().world(world);
        const TriggerHandle handle = readHandle<HandleType::Trigger>(trigger, "trigger");
        requireAlive(hosted->loop.world().triggers(), handle, "trigger");
        RowWriter<rubble_body> rows(out, capacity, count);
        for (const BodyHandle body : hosted->loop.world().triggers().at(handle).inside)
            rows.add([&] { return body.bits; });
        rows.finish();
    });
}

}  // namespace rubble::abi
