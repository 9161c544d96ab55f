#pragma once
#include <vector>

#include "runtime/plugin/include/rubble/rubble.h"
#include "runtime/world/world.h"

namespace rubble::abi {

/// The rows that rubble_events points at, kept until the next step. They keep their memory, so a calm step allocates
/// nothing.
class EventRows {
public:
    void fill(const FrameChanges& changes);
    /// The rows and the scalars; struct_size is left to the caller.
    rubble_events view() const;

private:
    uint64_t m_step = 0, m_painted = 0;
    bool m_levelReplaced = false;
    std::vector<rubble_removed_voxels> m_removed;
    std::vector<rubble_shape_split> m_splits;
    std::vector<rubble_body> m_bodiesCreated, m_bodiesDestroyed;
    std::vector<rubble_shape> m_shapesCreated, m_shapesDestroyed;
    std::vector<rubble_light_group> m_groupsOut;
    std::vector<rubble_dust_cloud> m_dust;
    std::vector<rubble_body> m_broken, m_settled, m_revived;
};

rubble_body_state bodyState(BodyHandle handle, const Body& body);
rubble_shape_state shapeState(const World& world, ShapeHandle handle, const Shape& shape);
rubble_hit hitState(const World& world, const WorldHit& hit);

}  // namespace rubble::abi
