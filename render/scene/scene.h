#pragma once
#include <vector>

#include "render/gl/program.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// The renderer's mirror of the world, fed by snapshots: bodies, shadow volume, lights and environment. [render-thread]
class Scene {
public:
    Scene();
    ~Scene();
    void apply(FrameSnapshot&& snapshot);

    const std::vector<SnapshotLight>& lights() const { return m_lights; }
    const Environment& environment() const { return m_environment; }
    /// Sets the samplers that lib/shadow_trace.glsl reads. The program must be in use.
    void bindShadow(const Program& program) const;
    /// Any shape with a palette entry of opacity < 255.
    bool hasGlass() const { return m_hasGlass; }
    /// World position that the GPU's coordinates are relative to.
    glm::dvec3 origin() const { return m_origin; }

private:
    std::vector<SnapshotLight> m_lights;
    Environment m_environment;
    glm::dvec3 m_origin{0.0};
    bool m_hasGlass = false;
};

}  // namespace rubble
