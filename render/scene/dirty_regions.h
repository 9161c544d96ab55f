#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "render/frame/shader_constants.h"
#include "runtime/shadow/shadow_volume.h"

namespace rubble {

/// Where shadow casters have changed since the last frame, as a few boxes: light histories around there are dropped
/// (passes/light_change.frag).
class DirtyRegions {
public:
    static constexpr size_t kMaxRegions = shared::kMaxDirtyRegions;
    static constexpr double kBrickMetres = 1.6;  ///< side of a brick of the shadow volume
    struct Box {
        glm::ivec3 low, high;  ///< bricks of the shadow volume, high excluded
    };

    /// Adds the bricks of these patches. A brick next to a box joins it; at kMaxRegions it joins the nearest one.
    void add(const std::vector<ShadowPatch>& patches);
    /// These, as those of the moment after `last`.
    DirtyRegions begin(const DirtyRegions& last) const;
    /// Whether there were any in the moment before.
    bool followOthers() const { return m_followOthers; }
    /// No region is dirty.
    void clear() { m_boxes.clear(); }
    /// At most kMaxRegions.
    const std::vector<Box>& boxes() const { return m_boxes; }

private:
    void add(glm::ivec3 brick);

    std::vector<Box> m_boxes;
    bool m_followOthers = false;
};

}  // namespace rubble
