#pragma once
#include <vector>

#include "physics/bodies/dynamic_body.h"
#include "physics/water/water.h"
#include "runtime/world/objects/character.h"

namespace rubble {

/// What a character can touch in a step.
struct CharacterSurroundings {
    std::vector<CollisionObject*> objects;  ///< within characterQueryRadius(), by number
    std::vector<const Character*> others;   ///< characters that it may touch, by slot
    const WaterVolumes* waters = nullptr;   ///< null: none
    glm::dvec3 gravity{0.0};                ///< m/s2
    double seconds = 1.0 / 60.0;
};

/// What a character does to a body that it walks into or stands on.
struct CharacterPush {
    DynamicBody* body = nullptr;
    glm::dvec3 impulse{0.0}, position{0.0};  ///< N s, and where it acts, world
    bool wakes = false;
    bool isNewLoad = false;  ///< the weight on the body has come, gone or moved: it may no longer be in balance
};

/// How far around its capsule a character may touch something in a step, metres.
double characterQueryRadius(const Character& character, double seconds);

/// Moves a character through one step, after the bodies have moved; see character.cpp for the method. Appends what it
/// does to bodies; the caller applies it. handles: of bodies, by slot.
void moveCharacter(Character& character, const CharacterSurroundings& around, const std::vector<BodyHandle>& handles,
                   std::vector<CharacterPush>& pushes);

}  // namespace rubble
