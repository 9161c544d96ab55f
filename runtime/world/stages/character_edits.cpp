#include "runtime/world/stages/character_edits.h"

#include <utility>

#include "runtime/core/log.h"
#include "runtime/core/number_range.h"

namespace rubble {
namespace {

/// Whether the numbers of a character are in range; false for a NaN.
bool isSane(const Character& c) {
    return isWithin(c.radius, 0.02, 10.0) && isWithin(c.height, 2.0 * c.radius, 100.0) &&
           isWithin(c.crouchedHeight, 2.0 * c.radius, c.height) && isWithin(c.stepHeight, 0.0, c.height) &&
           isWithin(c.maxSlope, 0.0, 1e3) && isWithin(c.mass, 1e-3, 1e6) && isWithin(c.walkSpeed, 0.0, 100.0) &&
           isWithin(c.crouchSpeed, 0.0, 100.0) && isWithin(c.jumpSpeed, 0.0, 100.0) &&
           isWithin(c.swimSpeed, 0.0, 100.0) && isWithin(c.maxPushForce, 0.0, 1e9) && isWithin(c.wish, 1e3) &&
           isWithin(c.position, 1e9) && isWithin(c.velocity, 1e3);
}

}  // namespace

void apply(EditContext& context, const AddCharacterEdit& edit) {
    if (!isSane(edit.character))
        return logWarning(
            "add_character: expected a radius of 0.02 m or more, a height of two radii or more and finite numbers; no "
            "character was added");
    Character character = edit.character;
    character.ground = {};
    context.changes.characters.push_back(context.world.characters.insert(std::move(character)));
}

void apply(EditContext& context, const RemoveCharacterEdit& edit) {
    if (!context.world.characters.erase(edit.character))
        return logWarning("remove_character: the handle of its character is stale; nothing was removed");
    context.changes.characters.push_back(edit.character);
}

void apply(EditContext& context, const MoveCharacterEdit& edit) {
    Character* character = context.world.characters.find(edit.character);
    if (!character || !isWithin(edit.wish, 1e3))
        return logWarning(
            "move_character: expected a character that exists and a velocity below 1 km/s; no character was moved");
    character->wish = edit.wish;
    character->wantsJump = edit.jump;
    character->wantsCrouch = edit.crouch;
    context.changes.characters.push_back(edit.character);
}

void apply(EditContext& context, const TeleportCharacterEdit& edit) {
    Character* character = context.world.characters.find(edit.character);
    if (!character || !isWithin(edit.position, 1e9) || !isWithin(edit.velocity, 1e3))
        return logWarning(
            "teleport_character: expected a character that exists and finite numbers; no character was teleported");
    character->position = edit.position;
    character->velocity = edit.velocity;
    character->grounded = false;
    character->ground = {};
    context.changes.characters.push_back(edit.character);
}

}  // namespace rubble
