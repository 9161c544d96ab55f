// What Godot calls in a GDNative library: it hands over its tables, and wants the classes.
#include "samples/hosts/godot/gdnative.h"
#include "samples/hosts/godot/voxel_body.h"
#include "samples/hosts/godot/voxel_character.h"
#include "samples/hosts/godot/voxel_world.h"

#define EXPORT __attribute__((visibility("default")))

extern "C" {

EXPORT void godot_gdnative_init(const gd::InitOptions* options) {
    gd::core = reinterpret_cast<void* const*>(options->api);
    for (uint32_t i = 0; i < options->api->extensionCount; ++i)
        if (options->api->extensions[i]->type == gd::kNativeScriptType)
            gd::nativeScript = reinterpret_cast<void* const*>(options->api->extensions[i]);
}

EXPORT void godot_gdnative_terminate(const void*) {}

EXPORT void godot_nativescript_init(void* handle) {
    rubble_godot::VoxelWorld::registerClass(handle);
    rubble_godot::VoxelBody::registerClass(handle);
    rubble_godot::VoxelCharacter::registerClass(handle);
}
}
