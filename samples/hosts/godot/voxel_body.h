#pragma once
#include <rubble/rubble.h>

#include <string>

#include "samples/hosts/godot/node_class.h"
#include "samples/hosts/godot/world_child.h"

namespace rubble_godot {

/// The node VoxelBody: a box of voxels in the VoxelWorld above it, where the node is. The node follows the body; when
/// nothing is left of it, the signal "destroyed" comes once. [main-thread]
class VoxelBody final : public WorldChild {
public:
    /// As Godot gives a node its script.
    explicit VoxelBody(gd::Object* node) : WorldChild(node) {}
    void spawn() override;
    void despawn() override;
    /// Registers the class.
    static void registerClass(void* handle);

    Vec3 size{10, 10, 10};          ///< voxels of 10 cm along each axis
    std::string material = "wood";  ///< of the world's table
    Color color{0.6f, 0.42f, 0.24f, 1};
    bool isStatic = false;

private:
    Variant physicsProcess(Arguments);
    Variant applyImpulse(Arguments);
    void paint(rubble_shape shape) const;

    rubble_body m_body = 0;
};

}  // namespace rubble_godot
