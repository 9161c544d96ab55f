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
    static constexpr double kWordMetres = 0.4;  ///< side of a word of the shadow volume
    struct Box {
        glm::ivec3 low, high;  ///< words of the shadow volume, high excluded
        float area = 0.0f;     ///< square metres: about as much of what has changed in it is seen from one side
    };

    /// Adds what has changed in these patches, a box of words for each. It joins another one where both together hold
    /// no more than they do, and at kMaxRegions the one that grows least.
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
    void add(const Box& box);

    std::vector<Box> m_boxes;
    bool m_followOthers = false;
};

}  // namespace rubble
