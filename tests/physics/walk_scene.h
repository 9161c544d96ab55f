#pragma once
#include <utility>

#include "runtime/world/queries/query.h"
#include "tests/physics/physics_scene.h"

namespace rubble {

/// A scene with one character.
struct Walk : PhysicsScene {
    /// A character with default sizes.
    explicit Walk(glm::dvec3 feet = {0.0, 0.01, 0.0}) {
        level.characters.emplace_back();
        level.characters[0].position = feet;
    }
    /// What the character wants from the next step on.
    void wish(glm::dvec3 velocity, bool jump = false, bool crouch = false) {
        edits.push_back(MoveCharacterEdit{who(), velocity, jump, crouch});
    }
    /// Steps; the edits are those of the first.
    void walk(int steps) {
        for (int i = 0; i < steps; ++i) stepWith(std::exchange(edits, {}));
    }
    /// Walks toward a velocity for a time and returns how far it came.
    glm::dvec3 go(glm::dvec3 velocity, double time) {
        const glm::dvec3 before = me().position;
        wish(velocity);
        walk(int(time * 60.0));
        return me().position - before;
    }
    /// The character.
    CharacterHandle who() const { return world.characters().handleAt(0); }
    /// Its state.
    const Character& me() const { return world.characters().at(who()); }
    /// Whether its capsule overlaps static voxels.
    bool isInside() const {
        const Character& c = me();
        const QueryShape capsule{.kind = QueryShapeKind::Capsule,
                                 .position = c.position + glm::dvec3(0, c.radius, 0),
                                 .end = c.position + glm::dvec3(0, c.currentHeight() - c.radius, 0),
                                 .radius = c.radius - 1e-6};
        return !overlappingShapes(world, capsule, {.rejectDynamic = true}).empty();
    }
    Edits edits;
};

}  // namespace rubble
