#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Turns views into the camera's part of the frame's uniforms, and remembers the last one for reprojection.
class FrameCamera {
public:
    /// Fills camera, matrices, sizes, jitter, noise and counters. traced: size in pixels of what is traced for the
    /// view. originWorld: what GPU coordinates are relative to.
    void begin(const View& view, glm::ivec2 traced, bool jittered, glm::dvec3 originWorld, FrameBlock& block);

private:
    glm::mat4 m_lastViewProjection{1.0f};
    glm::vec4 m_lastPosition{0.0f};
    glm::vec2 m_lastJitter{0.0f};
    glm::ivec2 m_lastSize{0};
    glm::dvec3 m_lastOrigin{0.0};
    int m_frame = 0;
};

}  // namespace rubble
