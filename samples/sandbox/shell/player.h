#pragma once
#include <rubble/rubble.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace sandbox {

/// A place and a rotation.
struct Frame {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
};

/// The one who plays: a character that walks, jumps, crouches and swims, or nobody who flies; and where his eyes are.
class Player {
public:
    /// The world must outlive it.
    Player(const rubble_api& api, rubble_world world) : m_api(api), m_world(world) {}

    /// How it shall move in the next step, in m/s of the world. Flying is as fast in all directions.
    void move(glm::dvec3 velocity, bool jumps, bool crouches);
    /// Where it looks: radians to the left of -z, and upwards.
    void look(double yaw, double pitch) { m_yaw = yaw, m_pitch = pitch; }
    /// Puts its feet somewhere.
    void place(glm::dvec3 feet);
    /// As a blow does, m/s.
    void push(glm::dvec3 velocity);
    /// Walks, or flies.
    void walk(bool walks) { m_walks = walks; }

    /// Before each step of the world.
    void beforeStep();
    /// After it.
    void afterStep();
    /// After a load or an undo, whose character stands elsewhere: it comes to where it is here, or with `stays` false
    /// stays where that is.
    void adopt(bool stays);

    /// The eyes between the last two steps, at 0 to 1.
    Frame eye(double alpha) const;
    /// Between its feet, after the last step.
    glm::dvec3 feet() const { return m_feet; }
    /// In m/s.
    glm::dvec3 velocity() const { return m_velocity; }
    /// As look() was given it.
    double yaw() const { return m_yaw; }
    /// The same.
    double pitch() const { return m_pitch; }
    /// Whether it walks, or flies.
    bool walks() const { return m_walks; }
    /// Whether it stands on something.
    bool isGrounded() const { return m_isGrounded; }
    /// Whether it swims.
    bool isSwimming() const { return m_isSwimming; }

private:
    void addCharacter();
    bool readState(rubble_character_state& state) const;

    const rubble_api& m_api;
    rubble_world m_world;
    rubble_character m_character = 0;
    glm::dvec3 m_feet{0.0}, m_lastFeet{0.0}, m_velocity{0.0}, m_wish{0.0}, m_push{0.0};
    double m_yaw = 0.0, m_pitch = 0.0;
    double m_eyes = 1.65, m_lastEyes = 1.65;  ///< metres above the feet
    bool m_walks = true, m_jumps = false, m_crouches = false, m_isGrounded = false, m_isSwimming = false;
    bool m_isPlaced = true;  ///< the character shall come to m_feet
};

}  // namespace sandbox
