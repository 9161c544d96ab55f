#pragma once
#include <vector>

#include "physics/bodies/dynamic_body.h"
#include "physics/collision/broadphase.h"
#include "physics/water/water.h"
#include "runtime/world/objects/character.h"

namespace rubble {

/// What a character could touch in a step.
struct CharacterSurroundings {
    std::vector<CollisionObject*> objects;  ///< near its displacement, by number
    const WaterVolumes* waters = nullptr;
    glm::dvec3 gravity{0.0};
    double seconds = 1.0 / 60.0;
};

/// What a character does to a body that is in its displacement, or that it stands on.
struct CharacterPush {
    DynamicBody* body = nullptr;
    glm::dvec3 impulse{0.0}, position{0.0};
    bool wakes = false;
};

/// How far around its feet a character looks for what it could touch in a step, metres.
double characterQueryRadius(const Character& character, double seconds);

/// One step of a character, after the bodies have made theirs: carried by what it stands on, pushed out of what came
/// into it, then moved by sweeps of its capsule, which end short of what they meet, so that it is never inside what
/// stands still. handles: of bodies, by slot.
void moveCharacter(Character& character, const CharacterSurroundings& around, const std::vector<BodyHandle>& handles,
                   std::vector<CharacterPush>& pushes);

}  // namespace rubble
