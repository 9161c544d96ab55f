#include "samples/sandbox/shell/player.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sandbox {
namespace {

constexpr double kStep = 1.0 / 60.0;
constexpr double kStandingEyes = 1.65, kCrouchedEyes = 0.98;  ///< metres above the feet
constexpr double kEyeRate = 0.2;                              ///< of the way to their height, a step
constexpr double kStair = 0.45;                               ///< metres that the eyes lag behind on stairs

void put(double (&to)[3], glm::dvec3 from) {
    to[0] = from.x, to[1] = from.y, to[2] = from.z;
}
glm::dvec3 vectorOf(const double (&from)[3]) {
    return {from[0], from[1], from[2]};
}

}  // namespace

void Player::move(glm::dvec3 velocity, bool jumps, bool crouches) {
    m_wish = velocity;
    m_jumps = jumps;
    m_crouches = crouches;
}

void Player::place(glm::dvec3 feet) {
    m_feet = m_lastFeet = feet;
    m_isPlaced = true;
}

void Player::push(glm::dvec3 velocity) {
    m_push = velocity;
}

void Player::addCharacter() {
    rubble_character_settings settings = {};
    settings.struct_size = sizeof settings;
    settings.walk_speed = 60.0;  // the game decides how fast
    put(settings.position, m_feet);
    m_api.create_character(m_world, &settings, &m_character);
    m_isPlaced = false;
}

void Player::beforeStep() {
    m_lastFeet = m_feet;
    m_lastEyes = m_eyes;
    if (!m_walks) {
        if (m_character) m_api.remove_character(m_world, m_character);
        m_character = 0;
        m_velocity = m_wish;
        m_feet += m_velocity * kStep;
        m_eyes += (kStandingEyes - m_eyes) * kEyeRate;
        m_isGrounded = m_isSwimming = false;
        return;
    }
    if (!m_character) return addCharacter();
    if (m_isPlaced || glm::length(m_push) > 0.0) {
        rubble_character_teleport teleport = {};
        teleport.struct_size = sizeof teleport;
        teleport.character = m_character;
        put(teleport.position, m_feet);
        put(teleport.velocity, m_push);
        m_api.teleport_character(m_world, &teleport);
        m_isPlaced = false;
        m_push = {};
    }
    rubble_character_move move = {};
    move.struct_size = sizeof move;
    move.character = m_character;
    put(move.desired_velocity, m_wish);
    move.flags = uint32_t(m_jumps ? RUBBLE_MOVE_JUMP : 0) | uint32_t(m_crouches ? RUBBLE_MOVE_CROUCH : 0);
    m_api.move_character(m_world, &move);
    m_jumps = false;
}

bool Player::readState(rubble_character_state& state) const {
    return m_character && m_api.get_character_state(m_world, m_character, &state) == RUBBLE_OK;
}

void Player::afterStep() {
    rubble_character_state state = {};
    if (!m_walks || m_isPlaced || !readState(state))
        return;  // what a script has placed in the step gets there in the next
    m_feet = vectorOf(state.position);
    m_velocity = vectorOf(state.velocity);
    m_isGrounded = state.flags & RUBBLE_CHARACTER_GROUNDED;
    m_isSwimming = state.flags & RUBBLE_CHARACTER_SWIMMING;
    const double height = state.flags & RUBBLE_CHARACTER_CROUCHED ? kCrouchedEyes : kStandingEyes;
    if (m_isGrounded) m_eyes -= std::clamp(m_feet.y - m_lastFeet.y, -kStair, kStair) - m_velocity.y * kStep;
    m_eyes = std::clamp(m_eyes + (height - m_eyes) * kEyeRate, height - kStair, height + kStair);
}

void Player::adopt(bool stays) {
    uint32_t count = 0;
    rubble_character_state states[16] = {};
    m_character = 0;
    if (m_api.get_character_states(m_world, states, 16, &count) == RUBBLE_OK && count)
        m_character = states[0].character;
    if (stays) return place(m_feet);
    if (m_character) m_feet = m_lastFeet = vectorOf(states[0].position);
}

Frame Player::eye(double alpha) const {
    const glm::dquat turn = glm::angleAxis(m_yaw, glm::dvec3(0, 1, 0)) * glm::angleAxis(m_pitch, glm::dvec3(1, 0, 0));
    return {glm::mix(m_lastFeet, m_feet, alpha) + glm::dvec3(0.0, glm::mix(m_lastEyes, m_eyes, alpha), 0.0), turn};
}

}  // namespace sandbox
