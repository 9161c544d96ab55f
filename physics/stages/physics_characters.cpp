#include "physics/stages/physics_characters.h"

#include <algorithm>

namespace rubble {
namespace {

/// Wakes a body whose load has changed, and what bears it. Settled bodies bear what comes.
void wakeLoaded(DynamicBody& body, PhysicsBodies& bodies) {
    std::vector<DynamicBody*> open{&body};
    while (!open.empty()) {
        DynamicBody& loaded = *open.back();
        open.pop_back();
        bodies.wakeOrWait(loaded);
        if (loaded.asleep()) continue;  // it waits for its turn
        loaded.restartRest();
        const CollisionObject& above = loaded.object;
        for (const CollisionObject* object :
             bodies.objectsIn(above.low - kTouchDistance, above.high + kTouchDistance)) {
            DynamicBody* below = object->dynamic;
            if (below && below->asleep() && !below->settled && !below->quarantined() && object->low.y < above.low.y)
                open.push_back(below);
        }
    }
}

}  // namespace

void PhysicsCharacters::load(const World& world, PhysicsBodies& bodies) {
    for (const auto& [handle, character] : m_characters) {
        const Character* now = world.characters().find(handle);
        DynamicBody* ground = bodies.find(character.ground);
        if (ground && !(now && now->ground == character.ground)) wakeLoaded(*ground, bodies);
    }
    m_characters.clear();
    world.characters().forEach(
        [&](CharacterHandle handle, const Character& character) { m_characters.emplace_back(handle, character); });
}

void PhysicsCharacters::sortByPlace() {
    m_places.clear();
    m_maxRadius = 0.0;
    for (size_t i = 0; i < m_characters.size(); ++i) {
        m_places.emplace_back(m_characters[i].second.position.x, i);
        m_maxRadius = std::max(m_maxRadius, m_characters[i].second.radius);
    }
    std::sort(m_places.begin(), m_places.end());
}

std::vector<const Character*> PhysicsCharacters::near(size_t index, double radius) const {
    std::vector<size_t> found;
    const double x = m_characters[index].second.position.x, reach = radius + m_maxRadius;
    for (auto i = std::lower_bound(m_places.begin(), m_places.end(), std::pair(x - reach, size_t(0)));
         i != m_places.end() && i->first <= x + reach; ++i)
        if (i->second != index) found.push_back(i->second);
    std::sort(found.begin(), found.end());
    std::vector<const Character*> others;
    for (const size_t i : found) others.push_back(&m_characters[i].second);
    return others;
}

double PhysicsCharacters::move(PhysicsBodies& bodies, const WaterVolumes* waters, glm::dvec3 gravity, double seconds) {
    double work = 0.0;
    sortByPlace();
    for (size_t i = 0; i < m_characters.size(); ++i) {
        auto& [handle, character] = m_characters[i];
        const Character before = character;
        const double radius = characterQueryRadius(character, seconds);
        const CharacterSurroundings around{
            .objects = bodies.objectsIn(before.position - radius,
                                        before.position + glm::dvec3(0.0, character.height, 0.0) + radius),
            .others = near(i, radius),
            .waters = waters,
            .gravity = gravity,
            .seconds = seconds};
        m_pushes.clear();
        moveCharacter(character, around, bodies.handles(), m_pushes);
        for (const CharacterPush& push : m_pushes) {
            if (push.isNewLoad) wakeLoaded(*push.body, bodies);
            if (push.wakes) bodies.wakeOrWait(*push.body);
            if (push.body->asleep()) continue;
            work -= kineticEnergy(push.body->motion);
            push.body->applyImpulse(push.impulse, push.position);
            work += kineticEnergy(push.body->motion);
        }
        character.wantsJump = false;
        if (character == before) continue;
        m_moves.push_back({handle, character.position, character.velocity, character.groundVelocity, character.grounded,
                           character.crouched, character.swimming, character.ground});
    }
    return work;
}

}  // namespace rubble
