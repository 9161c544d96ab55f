#pragma once
#include <rubble/rubble.h>

#include <array>
#include <memory>

#include "samples/hosts/godot/gl_target.h"
#include "samples/hosts/godot/variant.h"

namespace rubble_godot {

class VoxelWorld;

/// A world in the frames of Godot: before each of them Rubble draws colours and depths into two textures, and a
/// rectangle over the whole frame gives them to Godot, which tests the depths against its own meshes. [main-thread]
class WorldView {
public:
    /// Of a world that keeps it.
    explicit WorldView(const VoxelWorld& owner) : m_owner(owner) {}
    ~WorldView();
    WorldView(const WorldView&) = delete;
    WorldView& operator=(const WorldView&) = delete;
    /// Draws the world for the camera of the node's viewport; with Godot's GL context current.
    void draw();
    /// How many values of the GL's state draws have changed, if VoxelWorld::checkState.
    int64_t changedState() const { return m_changedState; }

private:
    bool open();
    void addRectangle();
    void resize(std::array<int32_t, 2> size);
    rubble_view makeView(gd::Object* camera) const;

    const VoxelWorld& m_owner;
    rubble_renderer m_renderer = 0;
    std::unique_ptr<GlTarget> m_target;
    std::array<int32_t, 2> m_size{};                                       // pixels of the viewport
    Variant m_colors, m_depths, m_shader, m_material, m_mesh, m_instance;  // RIDs of Godot's VisualServer
    int64_t m_changedState = 0;
    bool m_failed = false;
};

}  // namespace rubble_godot
