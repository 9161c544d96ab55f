#pragma once
#include <rubble/rubble.h>

#include <unordered_map>
#include <vector>

#include "samples/hosts/godot/variant.h"

namespace rubble_godot {

class VoxelWorld;

/// The bodies of a world as bodies of Godot's physics, which moves them: each is a compound of boxes about its centre
/// of mass. [main-thread]
class GodotBodies {
public:
    /// Of a world that keeps it.
    explicit GodotBodies(const VoxelWorld& owner) : m_owner(owner) {}
    ~GodotBodies();
    GodotBodies(const GodotBodies&) = delete;
    GodotBodies& operator=(const GodotBodies&) = delete;
    /// Removes all, as when a level is loaded.
    void clear();
    /// Before a step of the world: says where Godot has moved the bodies and what they hit.
    void tell();
    /// After it: makes, changes and removes bodies as the step did.
    void follow();
    /// What tell() has said of hits.
    const std::vector<rubble_impact>& impacts() const { return m_impacts; }

private:
    struct Body {
        Variant rid;
        std::vector<Variant> boxes;
        Vec3 center{};    // of mass, in the frame of the body of Rubble
        Vec3 velocity{};  // before Godot's last step
        bool moves = false, asleep = false;
    };
    void setCollider(const rubble_rigid_body& row, Body& body);
    void setMotion(const rubble_rigid_body& row, Body& body);
    void remove(rubble_body handle);
    void tellBody(rubble_body handle, Body& body);
    void tellContacts(rubble_body handle, const Body& body);

    const VoxelWorld& m_owner;
    std::unordered_map<rubble_body, Body> m_bodies;
    std::unordered_map<uint64_t, rubble_body> m_handles;  // by the RID's key
    std::vector<rubble_body_state> m_states;
    std::vector<rubble_impact> m_impacts;
};

}  // namespace rubble_godot
