#include "samples/hosts/godot/voxel_character.h"

#include "samples/hosts/godot/spatial_math.h"

namespace rubble_godot {

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

void VoxelCharacter::spawn() {
    rubble_character_settings settings = {.struct_size = sizeof settings};
    copy(m_start.origin, settings.position);
    settings.height = height, settings.radius = radius, settings.jump_speed = jumpSpeed;
    m_world->call("VoxelCharacter", &rubble_api::create_character, &settings, &m_character);
}

void VoxelCharacter::despawn() {
    if (m_character) m_world->api().remove_character(m_world->world(), m_character);
    m_character = 0;
}

Variant VoxelCharacter::move(Arguments arguments) {
    rubble_character_move move = {.struct_size = sizeof move, .character = m_character};
    copy(arguments.get<Vec3>(0), move.desired_velocity);
    move.flags = arguments.get<bool>(1) ? RUBBLE_MOVE_JUMP : 0;
    if (m_world && m_character) m_world->call("VoxelCharacter.move", &rubble_api::move_character, &move);
    return {};
}

Variant VoxelCharacter::physicsProcess(Arguments) {
    rubble_character_state state;
    if (!m_world || !m_character) return {};
    if (!m_world->call("VoxelCharacter", &rubble_api::get_character_state, m_character, &state)) return {};
    Transform here = place();
    here.origin = toVec3(state.position);
    setPlace(here);
    m_grounded = state.flags & RUBBLE_CHARACTER_GROUNDED;
    return {};
}

}  // namespace rubble_godot
