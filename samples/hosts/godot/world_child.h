#pragma once
#include "samples/hosts/godot/voxel_world.h"

namespace rubble_godot {

/// A node that lives in the VoxelWorld above it, from where it was in the editor on. [main-thread]
class WorldChild {
public:
    /// As Godot gives a node its script.
    explicit WorldChild(gd::Object* node) : m_node(node) {}
    virtual ~WorldChild() = default;
    /// Makes it, also after the world has loaded its level again.
    virtual void spawn() = 0;
    /// Removes it.
    virtual void despawn() = 0;

protected:
    /// For Godot to call as _enter_tree.
    Variant enterTree(Arguments);
    /// For Godot to call as _exit_tree.
    Variant exitTree(Arguments);
    /// Where the node is.
    Transform place() const;
    /// Moves the node.
    void setPlace(const Transform& place) const;

    gd::Object* m_node;
    VoxelWorld* m_world = nullptr;  ///< above it, while it is in the tree
    Transform m_start;              ///< where the node was at first
};

}  // namespace rubble_godot
