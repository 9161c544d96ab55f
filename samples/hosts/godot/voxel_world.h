#pragma once
#include <rubble/rubble.h>

#include <memory>
#include <string>
#include <vector>

#include "samples/hosts/godot/brick_meshes.h"
#include "samples/hosts/godot/godot_bodies.h"
#include "samples/hosts/godot/godot_lights.h"
#include "samples/hosts/godot/node_class.h"
#include "samples/hosts/godot/world_view.h"

namespace rubble_godot {

class WorldChild;

/// The node VoxelWorld: a world of Rubble that plays with Godot's physics frames, 60 a second. With the whole library
/// it moves and draws its voxels itself; with the runtime alone Godot's physics and meshes do. World positions are
/// Godot's. Children of it that are VoxelBody and VoxelCharacter live in it. [main-thread]
class VoxelWorld {
public:
    /// As Godot gives a node its script.
    explicit VoxelWorld(gd::Object* node) : m_node(node) {}
    ~VoxelWorld() { close(); }
    /// Registers the class.
    static void registerClass(void* handle);
    /// The world whose node is an ancestor of this one; null: there is none.
    static VoxelWorld* above(gd::Object* node);

    /// The functions of Rubble; of a world that is in the tree.
    const rubble_api& api() const { return *m_api; }
    /// 0: it could not be made.
    rubble_world world() const { return m_world; }
    /// Its node.
    gd::Object* node() const { return m_node; }
    /// Spawns something, now and whenever the level is loaded again.
    void add(WorldChild& child);
    /// Forgets it.
    void remove(WorldChild& child);
    /// Prints the last error, unless a call came out; returns whether it did.
    bool check(rubble_result result, const char* what) const;
    /// Calls a function of Rubble for this world, with the arguments behind that of the world; the same.
    template <class Function, class... Arguments>
    bool call(const char* what, Function rubble_api::*function, Arguments... arguments) const {
        return check((m_api->*function)(m_world, arguments...), what);
    }

    std::string level;            ///< a .rubble or .vox file by Godot's path; "": an empty world
    std::string preset = "fast";  ///< of the renderer
    bool sky = true;              ///< the world's own sky is drawn
    bool godotLights = true;      ///< lights of Godot below this node light the voxels
    double brightness = 0.5;      ///< factor on the world's radiance, which Godot's tone mapping makes colours of
    bool waitForShadow = false;   ///< each step waits for the shadow volume: the same frames on every machine
    bool checkState = false;      ///< compares the GL's state before and after each draw

private:
    // What Godot calls.
    Variant enterTree(Arguments);
    Variant exitTree(Arguments);
    Variant physicsProcess(Arguments);
    Variant drawWorld(Arguments);
    // What scripts call.
    Variant breakAt(Arguments);
    Variant explode(Arguments);
    Variant castRay(Arguments);
    Variant pieceCount(Arguments) { return m_pieces; }
    Variant removedVoxels(Arguments) { return m_removed; }
    Variant bodyCount(Arguments);
    Variant changedState(Arguments) { return m_view ? m_view->changedState() : 0; }
    Variant layers(Arguments);
    Variant reload(Arguments);

    void open();
    void close();
    bool loadLevel();
    bool destroyBodies();
    void reportBreaks();
    void reportHits();

    gd::Object* m_node;
    const rubble_api* m_api = nullptr;
    rubble_world m_world = 0;
    std::unique_ptr<WorldView> m_view;      // of a library with a renderer
    std::unique_ptr<BrickMeshes> m_meshes;  // else
    std::unique_ptr<GodotBodies> m_bodies;  // of a library without physics
    GodotLights m_lights{*this};
    std::vector<WorldChild*> m_children;
    int64_t m_pieces = 0, m_removed = 0;
};

}  // namespace rubble_godot
