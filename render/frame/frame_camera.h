#pragma once
#include "render/frame/frame_block.h"
#include "render/frame/render_settings.h"

namespace rubble {

/// Fills the camera's part of the frame's uniforms, and keeps last frame's for reprojection.
class FrameCamera {
public:
    /// Fills camera, matrices, sizes, jitter, noise and counters.
    /// renderSize: pixels that are traced for the view. jittered: for temporal anti-aliasing. originWorld: the point of
    /// the world that GPU coordinates are relative to.
    void begin(const View& view, glm::ivec2 renderSize, bool jittered, glm::dvec3 originWorld, FrameBlock& block);

private:
    glm::mat4 m_lastViewProjection{1.0f};
    glm::vec4 m_lastPosition{0.0f}, m_lastMiddle{0.0f}, m_lastRight{0.0f}, m_lastUp{0.0f};
    glm::vec2 m_lastJitter{0.0f};
    glm::ivec2 m_lastSize{0};
    bool m_wasOrthographic = false;
    glm::dvec3 m_lastOrigin{0.0};
    int m_frame = 0;  ///< since the start or the last cut
};

}  // namespace rubble
