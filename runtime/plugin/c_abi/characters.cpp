#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/rows.h"
#include "runtime/world/objects/body_mass.h"
#include "runtime/world/objects/object_errors.h"

namespace rubble::abi {
namespace {

glm::dvec3 readVelocity(const double (&given)[3], const char* name) {
    const glm::dvec3 velocity = readVector(given, name);
    requireNoError(characterVelocityError(name, velocity));
    return velocity;
}

AddCharacterEdit readCharacter(const World&, const rubble_character_settings& given) {
    Character c;
    c.position = readVector(given.position, "position");
    c.radius = readOrDefault(given.radius, ranges::kCharacterRadius, c.radius, "radius");
    const NumberRange heights{2.0 * c.radius, ranges::kMaxCharacterHeight};
    c.height = readOrDefault(given.height, heights, c.height, "height");
    c.crouchedHeight = readOrDefault(given.crouched_height, heights, c.crouchedHeight, "crouched_height");
    c.stepHeight = readOrDefault(given.step_height, {0.0, c.height}, c.stepHeight, "step_height");
    c.maxSlope = readOrDefault(given.max_slope, ranges::kSlope, c.maxSlope, "max_slope");
    c.mass = readOrDefault(given.mass, ranges::kCharacterMass, c.mass, "mass");
    c.walkSpeed = readOrDefault(given.walk_speed, ranges::kCharacterSpeed, c.walkSpeed, "walk_speed");
    c.jumpSpeed = readOrDefault(given.jump_speed, ranges::kCharacterSpeed, c.jumpSpeed, "jump_speed");
    c.swimSpeed = readOrDefault(given.swim_speed, ranges::kCharacterSpeed, c.swimSpeed, "swim_speed");
    c.maxPushForce = readOrDefault(given.max_push_force, ranges::kForce, c.maxPushForce, "max_push_force");
    requireNoError(objectError(c));
    return {c};
}

MoveCharacterEdit readMove(const World& world, const rubble_character_move& given) {
    readFlags(given.flags, RUBBLE_MOVE_JUMP | RUBBLE_MOVE_CROUCH, "flags");
    return {readLiveHandle<HandleType::Character>(world.characters(), given.character, "character"),
            readVelocity(given.desired_velocity, "desired_velocity"), (given.flags & RUBBLE_MOVE_JUMP) != 0,
            (given.flags & RUBBLE_MOVE_CROUCH) != 0};
}

TeleportCharacterEdit readTeleport(const World& world, const rubble_character_teleport& given) {
    return {readLiveHandle<HandleType::Character>(world.characters(), given.character, "character"),
            readVector(given.position, "position"), readVelocity(given.velocity, "velocity")};
}

rubble_character_state characterState(CharacterHandle handle, const Character& character) {
    rubble_character_state row = {};
    row.character = handle.bits;
    writeVector(row.position, character.position);
    writeVector(row.velocity, character.velocity + character.groundVelocity);
    row.ground_body = character.ground.bits;
    row.flags = (character.grounded ? RUBBLE_CHARACTER_GROUNDED : 0) |
                (character.crouched ? RUBBLE_CHARACTER_CROUCHED : 0) |
                (character.swimming ? RUBBLE_CHARACTER_SWIMMING : 0);
    return row;
}

rubble_result addCharacter(rubble_world world, const rubble_character_settings* character) {
    return pushMotionEdit("add_character", world, character, "character", readCharacter);
}
rubble_result createCharacter(rubble_world world, const rubble_character_settings* character, rubble_character* out) {
    return inWorld("create_character", world, [&](HostedWorld& hosted) {
        if (!isGiven(out, "out")) return;
        *out = 0;
        requirePhysics(hosted);
        const rubble_character_settings given = readStruct(character, "settings");
        if (!isRefused()) pushMaker(hosted, readCharacter(hosted.loop.world(), given), &WorldObjects::characters, out);
    });
}
rubble_result removeCharacter(rubble_world world, rubble_character character) {
    return removeOne<RemoveCharacterEdit, HandleType::Character>("remove_character", world, character, "character",
                                                                 &World::characters);
}
rubble_result moveCharacter(rubble_world world, const rubble_character_move* move) {
    return pushMotionEdit("move_character", world, move, "move", readMove);
}
rubble_result teleportCharacter(rubble_world world, const rubble_character_teleport* teleport) {
    return pushMotionEdit("teleport_character", world, teleport, "teleport", readTeleport);
}

rubble_result getCharacterStates(rubble_world world, rubble_character_state* out, uint32_t capacity, uint32_t* count) {
    return listRows("get_character_states", world, out, capacity, count);
}
rubble_result getCharacterState(rubble_world world, rubble_character character, rubble_character_state* out) {
    return inWorld("get_character_state", world, [&](const HostedWorld& hosted) {
        const Character* found =
            findLive<HandleType::Character>(hosted.loop.world().characters(), character, "character");
        if (found && isGiven(out, "out")) *out = characterState(CharacterHandle{character}, *found);
    });
}

}  // namespace

void writeRows(const HostedWorld& hosted, RowWriter<rubble_character_state>& rows) {
    const World& world = hosted.loop.world();
    world.characters().forEach([&](CharacterHandle handle, const Character& character) {
        rows.add([&] { return characterState(handle, character); });
    });
}

void setCharacterFunctions(rubble_api& api) {
    api.add_character = addCharacter;
    api.create_character = createCharacter;
    api.remove_character = removeCharacter;
    api.move_character = moveCharacter;
    api.teleport_character = teleportCharacter;
    api.get_character_states = getCharacterStates;
    api.get_character_state = getCharacterState;
}

}  // namespace rubble::abi
