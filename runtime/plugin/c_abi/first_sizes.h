#pragma once
#include <cstdint>

#include "runtime/plugin/include/rubble/rubble.h"

namespace rubble::abi {

/// Every struct of the interface with its size in the first version that had it. These numbers never change: a host
/// that was built with that version gives them as struct_size, or has arrays of such rows.
#define RUBBLE_FIRST_SIZES(X)          \
    X(rubble_host, 32)                 \
    X(rubble_world_settings, 8)        \
    X(rubble_bounds, 56)               \
    X(rubble_carve, 152)               \
    X(rubble_break, 72)                \
    X(rubble_explosion, 48)            \
    X(rubble_paint, 56)                \
    X(rubble_impulse, 64)              \
    X(rubble_joint_settings, 264)      \
    X(rubble_joint_motor, 48)          \
    X(rubble_drive, 40)                \
    X(rubble_joint_state, 88)          \
    X(rubble_grab, 80)                 \
    X(rubble_release, 32)              \
    X(rubble_removed_voxels, 24)       \
    X(rubble_shape_split, 32)          \
    X(rubble_dust_cloud, 72)           \
    X(rubble_events, 160)              \
    X(rubble_body_state, 120)          \
    X(rubble_shape_state, 104)         \
    X(rubble_voxel_accounting, 40)     \
    X(rubble_step_stats, 80)           \
    X(rubble_collision_filter, 24)     \
    X(rubble_collision_shape, 16)      \
    X(rubble_water_settings, 80)       \
    X(rubble_trigger_settings, 120)    \
    X(rubble_trigger_event, 24)        \
    X(rubble_character_settings, 112)  \
    X(rubble_character_move, 40)       \
    X(rubble_character_teleport, 64)   \
    X(rubble_character_state, 72)      \
    X(rubble_query_filter, 40)         \
    X(rubble_ray, 64)                  \
    X(rubble_query_shape, 120)         \
    X(rubble_shape_cast, 152)          \
    X(rubble_hit, 96)                  \
    X(rubble_row_list, 24)             \
    X(rubble_heat, 64)                 \
    X(rubble_extinguish, 48)           \
    X(rubble_fire, 48)                 \
    X(rubble_body_change, 120)         \
    X(rubble_resize, 40)               \
    X(rubble_voxel_box, 40)            \
    X(rubble_body_settings, 112)       \
    X(rubble_voxel_run, 8)             \
    X(rubble_shape_settings, 136)      \
    X(rubble_prefab, 96)               \
    X(rubble_prefab_row, 16)           \
    X(rubble_refusal, 16)              \
    X(rubble_settings, 168)            \
    X(rubble_palette_entry, 32)        \
    X(rubble_palette_range, 32)        \
    X(rubble_rigid_body, 208)          \
    X(rubble_body_box, 96)             \
    X(rubble_body_impulse, 56)         \
    X(rubble_impact, 80)               \
    X(rubble_environment, 280)         \
    X(rubble_light_settings, 168)      \
    X(rubble_renderer_settings, 32)    \
    X(rubble_view, 96)                 \
    X(rubble_material, 96)             \
    X(rubble_body_properties, 112)     \
    X(rubble_cell_box, 24)             \
    X(rubble_shape_change, 56)         \
    X(rubble_shape_properties, 56)     \
    X(rubble_light_group_settings, 16) \
    X(rubble_light_group_change, 56)   \
    X(rubble_light_group_state, 56)    \
    X(rubble_draw_stats, 48)           \
    X(rubble_report_filter, 40)        \
    X(rubble_contact, 128)             \
    X(rubble_break_report, 48)         \
    X(rubble_joint_report, 56)         \
    X(rubble_fire_report, 40)          \
    X(rubble_water_report, 56)         \
    X(rubble_footstep, 56)             \
    X(rubble_reports, 80)              \
    X(rubble_brick, 16)                \
    X(rubble_brick_changes, 24)        \
    X(rubble_mesh_vertex, 36)          \
    X(rubble_shadow_brick, 536)        \
    X(rubble_particle_burst, 144)      \
    X(rubble_particle, 72)             \
    X(rubble_rope_point, 56)           \
    X(rubble_joint_properties, 104)    \
    X(rubble_body_constraint, 96)      \
    X(rubble_location, 64)             \
    X(rubble_level_script, 16)         \
    X(rubble_overlay_item, 416)        \
    X(rubble_overlay_image, 32)

/// The size of a struct in the first version that had it; for handles and numbers their size. The table is of pointers
/// of eight bytes. Where they have four, as in browsers, library and host are one program, of one version.
template <class T>
inline constexpr uint32_t kFirstSize = 0;
template <>
inline constexpr uint32_t kFirstSize<uint64_t> = 8;
template <>
inline constexpr uint32_t kFirstSize<double> = 8;
#define RUBBLE_FIRST_SIZE(type, size) \
    template <>                       \
    inline constexpr uint32_t kFirstSize<type> = sizeof(void*) == 8 ? size : sizeof(type);
RUBBLE_FIRST_SIZES(RUBBLE_FIRST_SIZE)
#undef RUBBLE_FIRST_SIZE

}  // namespace rubble::abi
