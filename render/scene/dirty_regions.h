#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/shadow/shadow_volume.h"

namespace rubble {

/// Where what casts shadows has changed since the last picture, as a few boxes: light around there is looked at anew.
class DirtyRegions {
public:
    static constexpr size_t kMaxRegions =
        8;  ///< boxes; what is over is joined to the nearest: passes/light_change.frag
    struct Box {
        glm::ivec3 low, high;  ///< bricks of the shadow volume, high excluded
    };

    void add(const std::vector<ShadowPatch>& patches);
    void clear() { m_boxes.clear(); }
    const std::vector<Box>& boxes() const { return m_boxes; }

private:
    void add(glm::ivec3 brick);

    std::vector<Box> m_boxes;
};

}  // namespace rubble
