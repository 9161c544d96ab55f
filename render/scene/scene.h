#pragma once
#include <deque>
#include <optional>
#include <vector>

#include "render/gl/program.h"
#include "render/scene/bodies.h"
#include "render/scene/body_grid.h"
#include "render/scene/dirty_regions.h"
#include "render/scene/gpu_shadow_volume.h"
#include "render/scene/smoke_shadow.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

struct FrameBlock;

/// The renderer's mirror of the world, fed by snapshots: bodies, shadow volume, lights and environment. [render-thread]
class Scene {
public:
    /// At once, unless its new bricks are more than the budget: then it waits, with all that comes after it, until they
    /// have been sent, and what is drawn meanwhile is the world before it. A level that replaces all never waits.
    void apply(FrameSnapshot&& snapshot);
    /// Bytes of changed bricks to send a frame.
    void setUploadBudget(uint64_t bytes) { m_uploadBudget = bytes; }
    /// Places what moves and sends what changed to the GPU. Returns the bytes sent.
    uint64_t beginFrame(float alpha, glm::dvec3 cameraWorld);

    const Bodies& bodies() const { return m_bodies; }
    const std::vector<SnapshotLight>& lights() const { return m_lights; }
    const std::vector<SnapshotParticle>& particles() const { return m_particles; }
    const std::vector<SnapshotRope>& ropes() const { return m_ropes; }
    const Environment& environment() const { return m_environment; }
    const std::vector<Water>& waters() const { return m_waters; }
    const std::vector<SnapshotRipple>& ripples() const { return m_ripples; }
    /// Of game time, at the step that is drawn.
    double seconds() const { return m_seconds; }
    /// Sets the samplers that lib/shadow_trace.glsl reads. The program must be in use.
    void bindShadow(const Program& program) const { m_shadow.bind(program); }
    /// Sets the samplers of lib/bodies.glsl and lib/voxel_at.glsl, which are there while the scene mirrors anything.
    /// The program must be in use.
    void bindVoxelsAt(const Program& program) const;
    /// Sets the uniforms of lib/smoke_shadow.glsl. The program must be in use.
    void bindSmoke(const Program& program) const { m_smoke.bind(program); }
    const GpuShadowVolume& shadow() const { return m_shadow; }
    /// Its place and extent, for lib/shadow_trace.glsl.
    void describeShadow(FrameBlock& block) const;
    /// Where what casts shadows has changed since endFrame().
    const DirtyRegions& dirtyRegions() const { return m_dirtyRegions; }
    void endFrame() { m_dirtyRegions.clear(); }
    /// Any shape with a palette entry of opacity < 255.
    bool hasGlass() const { return m_bodies.hasGlass(); }
    /// How often shapes with glass have changed or moved, or the sun has.
    uint64_t glassChanges() const { return m_glassChanges; }
    /// Any shape with a palette entry smooth enough to mirror.
    /// Voxels can be looked up for bounced light, not only for mirrors: see bindVoxelsAt().
    void setBounceColors(bool wanted) { m_bounceColors = wanted; }
    bool hasMirrors() const { return m_bodies.hasMirrors(); }
    /// World position that the GPU's coordinates are relative to: a corner of the shadow volume's sectors.
    glm::dvec3 origin() const { return m_origin; }
    uint64_t bytes() const {
        return m_bodies.bytes() + m_shadow.bytes() + m_smoke.bytes() + (m_grid ? m_grid->bytes() : 0);
    }

private:
    bool isGlass(ShapeHandle shape) const;
    bool touchesGlass(const FrameSnapshot& snapshot) const;
    struct Deferred {
        FrameSnapshot snapshot;
        uint64_t bricksSent;  ///< when it can be applied
    };
    /// Leaves the lists of bricks as they are.
    void applyNow(FrameSnapshot& snapshot);
    void applyDeferred();
    uint64_t updateGrid();

    Bodies m_bodies;
    std::optional<BodyGrid> m_grid;  ///< while anything mirrors, or bounced light has colours
    bool m_bounceColors = false;
    std::deque<Deferred> m_deferred;  ///< oldest first
    uint64_t m_uploadBudget = ~uint64_t(0);
    bool m_sendAll = false;  ///< a level was loaded
    GpuShadowVolume m_shadow;
    DirtyRegions m_dirtyRegions;
    SmokeShadow m_smoke;
    std::vector<SnapshotLight> m_lights;
    std::vector<SnapshotParticle> m_particles;
    std::vector<SnapshotRope> m_ropes;
    std::vector<Water> m_waters;
    std::vector<SnapshotRipple> m_ripples;
    double m_seconds = 0.0;
    uint64_t m_glassChanges = 0;
    bool m_smokeChanged = false;
    Environment m_environment;
    glm::dvec3 m_origin{0.0};
};

}  // namespace rubble
