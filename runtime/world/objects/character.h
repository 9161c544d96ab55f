#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "runtime/core/handle.h"

namespace rubble {

/// A walking character: an upright capsule. Hosts set what it wants; physics moves it through the voxel world.
struct Character {
    std::string name;
    // What it is
    double radius = 0.3;          ///< metres
    double height = 1.8;          ///< metres, feet to crown
    double crouchedHeight = 1.1;  ///< metres
    double stepHeight = 0.45;     ///< metres that it climbs without a jump
    double maxSlope = 1.0;        ///< largest slope that it can stand on, rise over run
    double mass = 80.0;           ///< kg
    double walkSpeed = 4.0;       ///< m/s; faster wishes are clamped
    double crouchSpeed = 1.8;     ///< m/s
    double jumpSpeed = 4.5;       ///< m/s
    double swimSpeed = 2.0;       ///< m/s
    double maxPushForce = 400.0;  ///< N, the most that it pushes bodies with
    uint8_t collisionLayer = 1;   ///< as Shape::collisionLayer
    uint8_t collisionMask = 255;
    // What it wants: the last MoveCharacterEdit
    glm::dvec3 wish{0.0};    ///< velocity, m/s; the vertical part counts in water only
    bool wantsJump = false;  ///< until it has jumped, or a step has passed
    bool wantsCrouch = false;
    // Where it is
    glm::dvec3 position{0.0};        ///< of the feet, metres, world
    glm::dvec3 velocity{0.0};        ///< m/s; while it is grounded, against what it stands on
    glm::dvec3 groundVelocity{0.0};  ///< m/s, world: of what it stands on, there; zero without ground
    bool grounded = false;
    bool crouched = false;
    bool swimming = false;
    BodyHandle ground;  ///< what it stands on, static or not; empty in the air and in a level

    /// A hash of all that decides what happens; the name is not in it.
    uint64_t hash() const;
    /// Height of the capsule now, metres.
    double currentHeight() const { return crouched ? crouchedHeight : height; }
    friend bool operator==(const Character&, const Character&) = default;
};

/// A character's new state, as physics hands it over.
struct CharacterMove {
    Handle<HandleType::Character> character;
    glm::dvec3 position{0.0}, velocity{0.0}, groundVelocity{0.0};
    bool grounded = false, crouched = false, swimming = false;
    BodyHandle ground;
};

}  // namespace rubble
