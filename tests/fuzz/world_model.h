#pragma once
#include <rubble/rubble.h>

#include <set>
#include <vector>

#include "tests/fuzz/object_mirror.h"

namespace rubble {

/// What a host may conclude about a world from rubble.h alone. Each check aborts, with a reason, where the world says
/// something else.
class WorldModel {
public:
    /// Of a world that has just been made. `api` must outlive it.
    WorldModel(const rubble_api& api, rubble_world world) : m_api(api), m_world(world), m_mirror(api, world) {
        restart();
    }
    /// What the host's calls have made and named.
    ObjectMirror& mirror() { return m_mirror; }

    /// The world was loaded, saved or recorded: all is read again.
    void restart();
    /// Nothing but steps, loads, saves and recordings changes what reads give.
    void requireUnchanged() const;
    /// Steps. Bodies and shapes change as the events say, and the sums of voxels agree.
    void step();
    /// Writes voxels into a box within a shape's grid when no edits wait, and steps: the cells hold them then, and all
    /// others what they held, unless the same step has broken or split the shape.
    void write(const rubble_shape_state& shape, const rubble_voxel_box& box, const std::vector<uint8_t>& voxels);

private:
    using Handles = std::set<uint64_t>;
    uint64_t hash() const;
    std::vector<rubble_shape_state> shapeRows() const;
    Handles bodies() const;
    Handles shapes() const;
    void requireSums() const;
    bool isBurning(rubble_shape shape) const;
    std::vector<uint8_t> voxels(const rubble_shape_state& shape) const;

    const rubble_api& m_api;
    rubble_world m_world;
    ObjectMirror m_mirror;
    uint64_t m_hash = 0;
    Handles m_bodies, m_shapes;
};

}  // namespace rubble
