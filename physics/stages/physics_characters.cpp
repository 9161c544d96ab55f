#include "physics/stages/physics_characters.h"

namespace rubble {

void PhysicsCharacters::load(const World& world) {
    m_characters.clear();
    world.characters().forEach(
        [&](CharacterHandle handle, const Character& character) { m_characters.emplace_back(handle, character); });
}

void PhysicsCharacters::move(PhysicsBodies& bodies, const WaterVolumes* waters, glm::dvec3 gravity, double seconds) {
    for (auto& [handle, character] : m_characters) {
        const Character before = character;
        const double radius = characterQueryRadius(character, seconds);
        const CharacterSurroundings around{
            .objects = bodies.objectsIn(before.position - radius,
                                        before.position + glm::dvec3(0.0, character.height, 0.0) + radius),
            .waters = waters,
            .gravity = gravity,
            .seconds = seconds};
        m_pushes.clear();
        moveCharacter(character, around, bodies.handles(), m_pushes);
        for (const CharacterPush& push : m_pushes) {
            if (push.wakes) bodies.wakeOrWait(*push.body);
            if (!push.body->asleep()) push.body->applyImpulse(push.impulse, push.position);
        }
        character.wantsJump = false;
        if (character == before) continue;
        m_moves.push_back({handle, character.position, character.velocity, character.grounded, character.crouched,
                           character.swimming, character.ground});
    }
}

}  // namespace rubble
