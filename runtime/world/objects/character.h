#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "runtime/core/handle.h"

namespace rubble {

/// One who walks: an upright capsule that is moved through the voxel world. Physics moves it; hosts say where it wants
/// to.
struct Character {
    std::string name;
    // what it is
    double radius = 0.3;          ///< metres
    double height = 1.8;          ///< metres, feet to crown
    double crouchedHeight = 1.1;  ///< metres
    double stepHeight = 0.45;     ///< metres that it climbs without a jump
    double steepest = 1.0;        ///< slope that it can stand on, rise over run
    double mass = 80.0;           ///< kg
    double walkSpeed = 4.0;       ///< m/s: wishes for more get this
    double crouchSpeed = 1.8;     ///< m/s
    double jumpSpeed = 4.5;       ///< m/s
    double swimSpeed = 2.0;       ///< m/s
    double pushForce = 400.0;     ///< N, at most, on bodies in its way
    uint8_t collisionLayer = 1;   ///< as of a shape
    uint8_t collisionMask = 255;
    // what it wants: the last MoveCharacterEdit
    glm::dvec3 wish{0.0};    ///< m/s; the vertical part counts in water only
    bool wantsJump = false;  ///< once: until it has jumped, or a step has passed
    bool wantsCrouch = false;
    // where it is
    glm::dvec3 position{0.0};  ///< of the feet, metres, world
    glm::dvec3 velocity{0.0};  ///< m/s
    bool grounded = false;
    bool crouched = false;
    bool swimming = false;
    BodyHandle ground;  ///< what it stands on, also what is static; empty in the air and in a level

    uint64_t hash() const;
    double currentHeight() const { return crouched ? crouchedHeight : height; }
    friend bool operator==(const Character&, const Character&) = default;
};

/// A character's new state, as physics hands it over.
struct CharacterMove {
    Handle<HandleType::Character> character;
    glm::dvec3 position{0.0}, velocity{0.0};
    bool grounded = false, crouched = false, swimming = false;
    BodyHandle ground;
};

}  // namespace rubble
