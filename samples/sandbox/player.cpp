#include "samples/sandbox/player.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr double kEyesBelowTop = 0.12;                // metres from the eyes to the top of the head
constexpr double kFlySpeed = 8.0, kFastFactor = 3.0;  // m/s
constexpr double kEyeFollowRate = 14.0;               // 1/s: smooths the eye's height over steps and crouching
constexpr const char* kName = "player";
constexpr const char* kTorchName = "player's torch";
constexpr glm::dvec3 kTorchOffset(0.25, -0.3, -0.2);  // from the eyes, in their frame, metres

/// The first object of this name; an empty handle if there is none.
template <class Handle, class T>
Handle findNamed(const SlotMap<Handle, T>& all, const char* name) {
    Handle found;
    all.forEach([&](Handle handle, const T& each) {
        if (!found && each.name == name) found = handle;
    });
    return found;
}

}  // namespace

void Player::place(const Pose& eye) {
    m_camera.position = eye.position;
    m_camera.lookAt(eye.position + eye.rotation * glm::dvec3(0, 0, -1));
    m_isSpawning = false;
}

Edits Player::move(const PlayerInput& input, const World& world, double seconds) {
    m_camera.turn(input);
    if (m_walks) return walk(input, world, seconds);
    m_isSpawning = false;
    m_camera.position += m_camera.flight(input) * (kFlySpeed * (input.fast ? kFastFactor : 1.0) * seconds);
    const CharacterHandle left = findNamed(world.characters(), kName);
    return left ? Edits{RemoveCharacterEdit{left}} : Edits{};
}

Edits Player::carryTorch(const World& world) const {
    const LightHandle handle = findNamed(world.lights(), kTorchName);
    if (!m_hasTorch) return handle ? Edits{RemoveLightEdit{handle}} : Edits{};
    const Light torch{.name = kTorchName,
                      .kind = LightKind::Cone,
                      .local = {m_camera.position + m_camera.rotation() * kTorchOffset, m_camera.rotation()},
                      .color = {30.0f, 27.0f, 22.0f},
                      .radius = 0.03f,
                      .reach = 30.0f,
                      .coneInner = 0.15f,
                      .coneOuter = 0.45f};
    if (!handle) return {AddLightEdit{torch}};
    return world.lights().at(handle).hash() == torch.hash() ? Edits{} : Edits{SetLightEdit{handle, torch}};
}

Edits Player::walk(const PlayerInput& input, const World& world, double seconds) {
    const CharacterHandle handle = findNamed(world.characters(), kName);
    const Character* character = world.characters().find(handle);
    if (!character) {
        if (std::exchange(m_isSpawning, true)) return {};
        Character player{.name = kName};
        player.position = m_camera.position - glm::dvec3(0.0, player.height - kEyesBelowTop, 0.0);
        return {AddCharacterEdit{player}};
    }
    m_isSpawning = false;
    follow(*character, seconds);
    const glm::dquat heading =
        character->swimming ? m_camera.rotation() : glm::angleAxis(m_camera.yaw, glm::dvec3(0, 1, 0));
    glm::dvec3 wish = heading * glm::dvec3(input.right, 0, -input.forward) * character->walkSpeed;
    if (character->swimming) wish.y += input.up * character->swimSpeed;
    return {MoveCharacterEdit{handle, wish, input.up > 0.0, input.up < 0.0}};
}

void Player::follow(const Character& character, double seconds) {
    const glm::dvec3 eye = character.position + glm::dvec3(0.0, character.currentHeight() - kEyesBelowTop, 0.0);
    const double y = m_camera.position.y + (eye.y - m_camera.position.y) * std::min(1.0, kEyeFollowRate * seconds);
    m_camera.position = {eye.x, std::clamp(y, eye.y - 0.6, eye.y + 0.6), eye.z};
}

}  // namespace rubble
