#include "samples/hosts/godot/voxel_body.h"

#include <algorithm>
#include <cmath>

#include "samples/hosts/godot/spatial_math.h"

namespace rubble_godot {
namespace {

const Method kEmitSignal{"Object", "emit_signal"};
constexpr double kVoxel = 0.1;  // metres
constexpr uint32_t kEntry = 1;  // of the palette: the one that a box has

}  // namespace

void VoxelBody::registerClass(void* handle) {
    NodeClass<VoxelBody>(handle, "VoxelBody", "Spatial")
        .method<&VoxelBody::enterTree>("_enter_tree")
        .method<&VoxelBody::exitTree>("_exit_tree")
        .method<&VoxelBody::physicsProcess>("_physics_process")
        .method<&VoxelBody::applyImpulse>("apply_impulse")
        .property<&VoxelBody::size>("size")
        .property<&VoxelBody::material>("material", {gd::kHintEnum, "wood,brick,concrete,metal,plastic,glass,ice"})
        .property<&VoxelBody::color>("color")
        .property<&VoxelBody::isStatic>("static")
        .signal("destroyed", {});
}

void VoxelBody::spawn() {
    rubble_body_settings body = {.struct_size = sizeof body, .flags = isStatic ? uint32_t(RUBBLE_BODY_STATIC) : 0u};
    copy(m_start.origin, body.position);
    toQuaternion(m_start, body.rotation);
    rubble_shape_settings box = {.struct_size = sizeof box, .source = RUBBLE_SHAPE_BOX};
    for (size_t i = 0; i < 3; ++i) {
        box.size[i] = int32_t(std::lround(size[i]));
        box.position[i] = -0.5 * kVoxel * box.size[i];  // the node is in the middle
    }
    box.index = kEntry;
    if (!m_world->call("VoxelBody", &rubble_api::create_body, &body, &m_body)) return;
    box.body = m_body;
    rubble_shape shape = 0;
    if (m_world->call("VoxelBody", &rubble_api::create_shape, &box, &shape)) paint(shape);
}

void VoxelBody::paint(rubble_shape shape) const {
    const rubble_palette_range range = {.struct_size = sizeof range, .shape = shape, .first = kEntry, .count = 1};
    rubble_palette_entry entry = {.roughness = 200, .reflectivity = 10};
    uint32_t index = 0;
    if (!m_world->call("VoxelBody.material", &rubble_api::find_material, material.c_str(), &index)) return;
    if (index == 0) printWarning("VoxelBody.material: expected a material of the world, found \"" + material + "\"");
    for (size_t i = 0; i < 3; ++i) entry.color[i] = uint8_t(std::lround(255 * std::clamp(color[i], 0.0f, 1.0f)));
    entry.opacity = uint8_t(std::lround(255 * std::clamp(color[3], 0.1f, 1.0f)));
    entry.material = uint8_t(index);
    m_world->call("VoxelBody", &rubble_api::set_palette, &range, &entry);
}

void VoxelBody::despawn() {
    if (m_body) m_world->api().destroy_body(m_world->world(), m_body);
    m_body = 0;
}

Variant VoxelBody::physicsProcess(Arguments) {
    rubble_body_state state;
    if (!m_world || !m_body) return {};
    // The world's node comes first, so its step has been played.
    const rubble_result result = m_world->api().get_body_state(m_world->world(), m_body, &state);
    if (result == RUBBLE_ERROR_STALE) {
        m_body = 0;
        kEmitSignal(m_node, "destroyed");
        return {};
    }
    if (!m_world->check(result, "VoxelBody")) return {};
    if (!(state.flags & (RUBBLE_BODY_ASLEEP | RUBBLE_BODY_STATIC)))
        setPlace(toTransform(state.position, state.rotation));
    return {};
}

Variant VoxelBody::applyImpulse(Arguments arguments) {
    rubble_impulse impulse = {.struct_size = sizeof impulse, .body = m_body};
    copy(arguments.get<Vec3>(0), impulse.position);
    copy(arguments.get<Vec3>(1), impulse.impulse);
    if (m_world && m_body) m_world->call("apply_impulse", &rubble_api::apply_impulse, &impulse);
    return {};
}

}  // namespace rubble_godot
