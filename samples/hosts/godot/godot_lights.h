#pragma once
#include <rubble/rubble.h>

#include <map>

#include "samples/hosts/godot/variant.h"

namespace rubble_godot {

class VoxelWorld;

/// Lights of Godot that are children of a VoxelWorld, as lights of Rubble: an OmniLight or SpotLight shines on voxels,
/// and a DirectionalLight is the sun. [main-thread]
class GodotLights {
public:
    /// Of a world that keeps it.
    explicit GodotLights(const VoxelWorld& owner) : m_owner(owner) {}
    /// Tells the world what has changed since the last call.
    void follow();
    /// Tells it all in the next call, as after a level was loaded.
    void forget();

private:
    void followSun(gd::Object* light);
    void followLight(gd::Object* light, bool isSpot);

    const VoxelWorld& m_owner;
    std::map<gd::Object*, rubble_light_settings> m_lights;
    double m_sun[3] = {};  // direction towards it
};

}  // namespace rubble_godot
