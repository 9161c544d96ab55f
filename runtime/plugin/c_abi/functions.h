#pragma once
#include "runtime/plugin/include/rubble/rubble.h"

// The functions of the table in rubble.h, by topic: each file sets its own. What they do stands in rubble.h.
namespace rubble::abi {

/// Sets get_last_error() and set_host().
void setHostFunctions(rubble_api& api);
/// Sets the functions that create, destroy, load and step worlds, and those of undo.
void setWorldFunctions(rubble_api& api);
/// Sets the edits of voxels and bodies, apply_impulse(), set_collision_filter() and set_collision_shape().
void setEditFunctions(rubble_api& api);
/// Sets the functions of joints, ropes, wheels and grabs.
void setJointFunctions(rubble_api& api);
/// Sets the functions of water and triggers.
void setRegionFunctions(rubble_api& api);
/// Sets the functions of characters.
void setCharacterFunctions(rubble_api& api);
/// Sets the functions of the environment and of lights.
void setLightFunctions(rubble_api& api);
/// Sets get_events() and the functions that read bodies, shapes, voxel accounting, hash and statistics.
void setStateFunctions(rubble_api& api);
/// Sets the edits of heat and the reads of fires.
void setFireFunctions(rubble_api& api);
/// Sets the edits of whole shapes, read_voxels(), write_voxels() and detach_joint().
void setShapeFunctions(rubble_api& api);
/// Sets create_body(), create_shape() and get_refusals().
void setCreateFunctions(rubble_api& api);
/// Sets create_prefab().
void setPrefabFunctions(rubble_api& api);
/// Sets read_rows().
void setRowFunctions(rubble_api& api);
/// Sets ray casts, shape casts, overlap queries and find_closest_point().
void setQueryFunctions(rubble_api& api);
/// Sets the functions of saved games and recordings, and translate_handle().
void setSaveFunctions(rubble_api& api);
/// Sets the functions of renderers.
void setRendererFunctions(rubble_api& api);
/// Sets the functions of places, scripts and data that a game carries.
void setHostDataFunctions(rubble_api& api);
/// Sets the functions of overlays.
void setOverlayFunctions(rubble_api& api);
/// Sets the functions of names, tags and user values, and the lists of objects.
void setObjectFunctions(rubble_api& api);
/// Sets set_settings() and get_settings().
void setSettingsFunctions(rubble_api& api);
/// Sets set_palette() and get_palette().
void setPaletteFunctions(rubble_api& api);
/// Sets the functions of files in memory.
void setDataFileFunctions(rubble_api& api);
/// Sets the functions of deltas.
void setDeltaFunctions(rubble_api& api);
/// Sets the functions of loading in the background.
void setLoadingFunctions(rubble_api& api);
/// Sets get_layers() and the functions of worlds that the host's physics moves.
void setHostPhysicsFunctions(rubble_api& api);
/// Sets the functions of the table of materials.
void setMaterialFunctions(rubble_api& api);
/// Sets the functions of the properties of bodies and shapes.
void setPropertyFunctions(rubble_api& api);
/// Sets create_light_group(), set_light_group() and get_light_group().
void setLightGroupFunctions(rubble_api& api);
/// Sets set_report_filter() and get_reports().
void setReportFunctions(rubble_api& api);
/// Sets the functions of bricks: what changed, their meshes and data, and those of the shadow volume.
void setBrickFunctions(rubble_api& api);
/// Sets spawn_particles() and get_particles().
void setParticleFunctions(rubble_api& api);

}  // namespace rubble::abi
