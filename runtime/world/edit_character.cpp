#include <cmath>

#include "runtime/core/log.h"
#include "runtime/world/edit_step.h"

namespace rubble {
namespace {

bool isSane(double value, double low, double high) {
    return value >= low && value <= high;  // false for a NaN
}

bool isSane(glm::dvec3 v, double limit) {
    return isSane(v.x, -limit, limit) && isSane(v.y, -limit, limit) && isSane(v.z, -limit, limit);
}

bool isSane(const Character& c) {
    return isSane(c.radius, 0.02, 10.0) && isSane(c.height, 2.0 * c.radius, 100.0) && isSane(c.crouchedHeight, 2.0 * c.radius, c.height) &&
           isSane(c.stepHeight, 0.0, c.height) && isSane(c.steepest, 0.0, 1e3) && isSane(c.mass, 1e-3, 1e6) && isSane(c.walkSpeed, 0.0, 100.0) &&
           isSane(c.crouchSpeed, 0.0, 100.0) && isSane(c.jumpSpeed, 0.0, 100.0) && isSane(c.swimSpeed, 0.0, 100.0) && isSane(c.pushForce, 0.0, 1e9) &&
           isSane(c.wish, 1e3) && isSane(c.position, 1e9) && isSane(c.velocity, 1e3);
}

}  // namespace

void EditStep::apply(const AddCharacterEdit& edit) {
    if (!isSane(edit.character))
        return logWarning("AddCharacterEdit: expected a radius of 0.02 m or more, a height of two radii or more and finite numbers; no one came");
    Character character = edit.character;
    character.ground = {};
    m_changes.characters.push_back(m_world.m_characters.insert(std::move(character)));
}

void EditStep::apply(const RemoveCharacterEdit& edit) {
    if (!m_world.m_characters.erase(edit.character)) return logWarning("RemoveCharacterEdit: the handle is stale; no one was removed");
    m_changes.characters.push_back(edit.character);
}

void EditStep::apply(const MoveCharacterEdit& edit) {
    Character* character = m_world.m_characters.find(edit.character);
    if (!character || !isSane(edit.wish, 1e3))
        return logWarning("MoveCharacterEdit: expected a character that is there and a wish below 1 km/s; no one moves");
    character->wish = edit.wish;
    character->wantsJump = edit.jump;
    character->wantsCrouch = edit.crouch;
    m_changes.characters.push_back(edit.character);
}

void EditStep::apply(const PlaceCharacterEdit& edit) {
    Character* character = m_world.m_characters.find(edit.character);
    if (!character || !isSane(edit.position, 1e9) || !isSane(edit.velocity, 1e3))
        return logWarning("PlaceCharacterEdit: expected a character that is there and finite numbers; no one was placed");
    character->position = edit.position;
    character->velocity = edit.velocity;
    character->grounded = false;
    character->ground = {};
    m_changes.characters.push_back(edit.character);
}

}  // namespace rubble
