#pragma once
#include <rubble/rubble.h>

#include "samples/hosts/godot/node_class.h"
#include "samples/hosts/godot/world_child.h"

namespace rubble_godot {

/// The node VoxelCharacter: a walking capsule in the VoxelWorld above it, whose feet are where the node is. Where
/// Godot's physics moves the bodies there is none: use a KinematicBody. [main-thread]
class VoxelCharacter final : public WorldChild {
public:
    /// As Godot gives a node its script.
    explicit VoxelCharacter(gd::Object* node) : WorldChild(node) {}
    void spawn() override;
    void despawn() override;
    /// Registers the class.
    static void registerClass(void* handle);

    double height = 1.8, radius = 0.3;  ///< metres
    double jumpSpeed = 4.5;             ///< metres a second

private:
    Variant physicsProcess(Arguments);
    Variant move(Arguments);
    Variant isGrounded(Arguments) { return m_grounded; }

    rubble_character m_character = 0;
    bool m_grounded = false;
};

}  // namespace rubble_godot
