#pragma once
#include <vector>

#include "runtime/plugin/include/rubble/rubble.h"
#include "runtime/world/world.h"

namespace rubble::abi {

/// The arrays that rubble_events points at, from one step to the next. They keep their memory: a step without events
/// allocates nothing.
class EventRows {
public:
    /// Replaces all rows by those of a step.
    void fill(const FrameChanges& changes);
    /// Removes all rows: the world that they were of is gone.
    void clear() { fill({}); }
    /// Pointers to the rows and their counts, valid until the next fill(); struct_size is left to the caller.
    rubble_events view() const;

private:
    uint64_t m_step = 0, m_painted = 0;
    bool m_levelLoaded = false;
    std::vector<rubble_removed_voxels> m_removed;
    std::vector<rubble_shape_split> m_splits;
    std::vector<rubble_dust_cloud> m_dust;
    std::vector<rubble_body> m_bodiesCreated, m_bodiesDestroyed, m_broken, m_settled, m_unsettled;
    std::vector<rubble_shape> m_shapesCreated, m_shapesDestroyed;
    std::vector<rubble_light_group> m_groupsOut;
};

}  // namespace rubble::abi
