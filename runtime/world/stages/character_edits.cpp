#include "runtime/world/stages/character_edits.h"

#include <utility>

#include "runtime/core/log.h"

namespace rubble {
void apply(EditContext& context, const AddCharacterEdit& edit) {
    Character character = edit.character;
    character.ground = {};
    character.groundVelocity = glm::dvec3(0.0);
    context.changes.characters.push_back(context.make(context.world.characters, std::move(character)));
}

void apply(EditContext& context, const RemoveCharacterEdit& edit) {
    if (!context.world.characters.erase(edit.character))
        return context.warnStale("remove_character: the handle of its character is stale; nothing was removed");
    context.changes.characters.push_back(edit.character);
}

void apply(EditContext& context, const MoveCharacterEdit& edit) {
    Character* character = context.world.characters.find(edit.character);
    if (!character)
        return context.warnStale("move_character: the handle of its character is stale; no character was moved");
    character->wish = edit.wish;
    character->wantsJump = edit.jump;
    character->wantsCrouch = edit.crouch;
    context.changes.characters.push_back(edit.character);
}

void apply(EditContext& context, const TeleportCharacterEdit& edit) {
    Character* character = context.world.characters.find(edit.character);
    if (!character)
        return context.warnStale(
            "teleport_character: the handle of its character is stale; no character was teleported");
    character->position = edit.position;
    character->velocity = edit.velocity;
    character->grounded = false;
    character->ground = {};
    character->groundVelocity = glm::dvec3(0.0);
    context.changes.characters.push_back(edit.character);
}

}  // namespace rubble
