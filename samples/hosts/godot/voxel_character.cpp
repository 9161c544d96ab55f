#include "samples/hosts/godot/voxel_character.h"

#include "samples/hosts/godot/spatial_math.h"

namespace rubble_godot {
namespace {

const Method kGetTransform{"Spatial", "get_global_transform"}, kSetTransform{"Spatial", "set_global_transform"};

}  // namespace

void VoxelCharacter::registerClass(void* handle) {
    NodeClass<VoxelCharacter>(handle, "VoxelCharacter", "Spatial")
        .method<&VoxelCharacter::enterTree>("_enter_tree")
        .method<&VoxelCharacter::exitTree>("_exit_tree")
        .method<&VoxelCharacter::physicsProcess>("_physics_process")
        .method<&VoxelCharacter::move>("move")
        .method<&VoxelCharacter::isGrounded>("is_grounded")
        .property<&VoxelCharacter::height>("height", {gd::kHintRange, "0.5,3,0.05"})
        .property<&VoxelCharacter::radius>("radius", {gd::kHintRange, "0.1,1,0.05"})
        .property<&VoxelCharacter::jumpSpeed>("jump_speed", {gd::kHintRange, "0.1,20,0.1"});
}

Variant VoxelCharacter::enterTree(Arguments) {
    m_start = kGetTransform(m_node).as<Transform>();
    m_world = VoxelWorld::above(m_node);
    if (m_world) m_world->add(*this);
    return {};
}

void VoxelCharacter::spawn() {
    rubble_character_settings settings = {.struct_size = sizeof settings};
    copy(m_start.origin, settings.position);
    settings.height = height, settings.radius = radius, settings.jump_speed = jumpSpeed;
    m_world->check(m_world->api().create_character(m_world->world(), &settings, &m_character), "VoxelCharacter");
}

Variant VoxelCharacter::exitTree(Arguments) {
    if (!m_world) return {};
    m_world->remove(*this);
    if (m_character) m_world->api().remove_character(m_world->world(), m_character);
    m_world = nullptr, m_character = 0;
    return {};
}

Variant VoxelCharacter::move(Arguments arguments) {
    rubble_character_move move = {.struct_size = sizeof move, .character = m_character};
    copy(arguments.get<Vec3>(0), move.desired_velocity);
    move.flags = arguments.get<bool>(1) ? RUBBLE_MOVE_JUMP : 0;
    if (m_world && m_character)
        m_world->check(m_world->api().move_character(m_world->world(), &move), "VoxelCharacter.move");
    return {};
}

Variant VoxelCharacter::physicsProcess(Arguments) {
    rubble_character_state state;
    if (!m_world || !m_character) return {};
    const rubble_result result = m_world->api().get_character_state(m_world->world(), m_character, &state);
    if (!m_world->check(result, "VoxelCharacter")) return {};
    Transform place = kGetTransform(m_node).as<Transform>();
    place.origin = toVec3(state.position);
    kSetTransform(m_node, place);
    m_grounded = state.flags & RUBBLE_CHARACTER_GROUNDED;
    return {};
}

}  // namespace rubble_godot
