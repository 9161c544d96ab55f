#include "runtime/world/stages/character_edits.h"

#include <utility>

#include "runtime/core/log.h"
#include "runtime/core/number_range.h"

namespace rubble {
namespace {

bool isSane(const Character& c) {
    return isWithin(c.radius, 0.02, 10.0) && isWithin(c.height, 2.0 * c.radius, 100.0) &&
           isWithin(c.crouchedHeight, 2.0 * c.radius, c.height) && isWithin(c.stepHeight, 0.0, c.height) &&
           isWithin(c.steepest, 0.0, 1e3) && isWithin(c.mass, 1e-3, 1e6) && isWithin(c.walkSpeed, 0.0, 100.0) &&
           isWithin(c.crouchSpeed, 0.0, 100.0) && isWithin(c.jumpSpeed, 0.0, 100.0) &&
           isWithin(c.swimSpeed, 0.0, 100.0) && isWithin(c.pushForce, 0.0, 1e9) && isWithin(c.wish, 1e3) &&
           isWithin(c.position, 1e9) && isWithin(c.velocity, 1e3);
}

}  // namespace

void apply(EditContext& context, const AddCharacterEdit& edit) {
    if (!isSane(edit.character))
        return logWarning(
            "AddCharacterEdit: expected a radius of 0.02 m or more, a height of two radii or more and finite numbers; "
            "no one came");
    Character character = edit.character;
    character.ground = {};
    context.changes.characters.push_back(context.world.characters.insert(std::move(character)));
}

void apply(EditContext& context, const RemoveCharacterEdit& edit) {
    if (!context.world.characters.erase(edit.character))
        return logWarning("RemoveCharacterEdit: the handle is stale; no one was removed");
    context.changes.characters.push_back(edit.character);
}

void apply(EditContext& context, const MoveCharacterEdit& edit) {
    Character* character = context.world.characters.find(edit.character);
    if (!character || !isWithin(edit.wish, 1e3))
        return logWarning(
            "MoveCharacterEdit: expected a character that is there and a wish below 1 km/s; no one moves");
    character->wish = edit.wish;
    character->wantsJump = edit.jump;
    character->wantsCrouch = edit.crouch;
    context.changes.characters.push_back(edit.character);
}

void apply(EditContext& context, const PlaceCharacterEdit& edit) {
    Character* character = context.world.characters.find(edit.character);
    if (!character || !isWithin(edit.position, 1e9) || !isWithin(edit.velocity, 1e3))
        return logWarning(
            "PlaceCharacterEdit: expected a character that is there and finite numbers; no one was placed");
    character->position = edit.position;
    character->velocity = edit.velocity;
    character->grounded = false;
    character->ground = {};
    context.changes.characters.push_back(edit.character);
}

}  // namespace rubble
