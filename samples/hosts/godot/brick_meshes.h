#pragma once
#include <rubble/rubble.h>

#include <array>
#include <map>
#include <unordered_map>
#include <vector>

#include "samples/hosts/godot/variant.h"

namespace rubble_godot {

class VoxelWorld;

/// A world as meshes of Godot: one for each brick of 8 x 8 x 8 voxels, remade when the brick changes. [main-thread]
class BrickMeshes {
public:
    /// Of a world that keeps it.
    explicit BrickMeshes(const VoxelWorld& owner);
    ~BrickMeshes();
    BrickMeshes(const BrickMeshes&) = delete;
    BrickMeshes& operator=(const BrickMeshes&) = delete;
    /// Brings the meshes up to date with the last step. Costs what has changed, and a question for each shape.
    void follow();

private:
    struct Brick {
        Variant mesh, instance;
    };
    struct Shape {
        uint64_t version = 0;
        std::map<std::array<int32_t, 3>, Brick> bricks;
        Transform place;
    };
    void update(rubble_shape shape);
    void drop(Shape& shape);
    void updateBrick(rubble_shape handle, Shape& shape, const rubble_brick& brick);
    /// Meshes and places of all shapes: soot, paint and light change meshes without an event.
    void updateAll();

    const VoxelWorld& m_owner;
    Variant m_shaders[2], m_materials[2];  // opaque, transparent
    std::unordered_map<rubble_shape, Shape> m_shapes;
    std::vector<rubble_shape_state> m_states;
    std::vector<rubble_mesh_vertex> m_vertices;
};

}  // namespace rubble_godot
