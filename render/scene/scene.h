#pragma once
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "render/gl/program.h"
#include "render/scene/bodies.h"
#include "render/scene/body_grid.h"
#include "render/scene/dirty_regions.h"
#include "render/scene/gpu_shadow_volume.h"
#include "render/scene/look_changes.h"
#include "render/scene/smoke_shadow.h"
#include "render/scene/water_outlines.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

struct FrameBlock;

/// The renderer's copy of the world, fed by snapshots: bodies, shadow volume, lights and environment. [render-thread]
class Scene {
public:
    /// Applies a snapshot at once, unless its new bricks are more than the upload budget. Then it is deferred, with all
    /// that come after it, until its bricks have been sent; meanwhile the world before it is drawn. A level that
    /// replaces all is never deferred.
    void apply(FrameSnapshot&& snapshot);
    /// Bytes of changed bricks to send per frame.
    void setUploadBudget(uint64_t bytes) { m_uploadBudget = bytes; }
    /// Whether indirect light looks up the colours of voxels: see bindVoxelsAt().
    void setBounceColors(bool wanted) { m_bounceColors = wanted; }
    /// Interpolates poses (alpha: 0 to 1 between the last two steps) and sends what changed. isSameMoment: another view
    /// is drawn of the moment of the last frame, so that motion and changes are still those since the moment before.
    /// hidden: shapes that it leaves out, but for their shadows. Returns the bytes sent.
    uint64_t beginFrame(float alpha, glm::dvec3 cameraWorld, bool isSameMoment = false,
                        std::span<const ShapeHandle> hidden = {});

    /// All shapes.
    const Bodies& bodies() const { return m_bodies; }
    /// All enabled lights, those of fires included.
    const std::vector<SnapshotLight>& lights() const { return m_lights; }
    /// All particles.
    const std::vector<SnapshotParticle>& particles() const { return m_particles; }
    /// All ropes.
    const std::vector<SnapshotRope>& ropes() const { return m_ropes; }
    /// Sun, sky, fog and weather.
    const Environment& environment() const { return m_environment; }
    /// All waters.
    const std::vector<Water>& waters() const { return m_waters; }
    /// Their outlines, by the same index.
    const WaterOutlines& waterOutlines() const { return m_outlines; }
    /// Rings on all waters.
    const std::vector<SnapshotRipple>& ripples() const { return m_ripples; }
    /// Game time of the step that is drawn, in seconds.
    double seconds() const { return m_seconds; }
    /// Sets the samplers of lib/shadow_trace.glsl and the uniforms of lib/moving_bodies.glsl. The program must be in
    /// use.
    void bindShadow(const Program& program) const {
        m_shadow.bind(program);
        m_bodies.touched().moving.bind(program);
    }
    /// Sets the samplers of lib/bodies.glsl and lib/voxel_at.glsl. No voxel is found in a scene in which nothing needs
    /// them: no reflections, no colours of indirect light. The program must be in use.
    void bindVoxelsAt(const Program& program) const;
    /// Sets the uniforms of lib/smoke_shadow.glsl. The program must be in use.
    void bindSmoke(const Program& program) const { m_smoke.bind(program); }
    /// The GPU's copy of the shadow volume.
    const GpuShadowVolume& shadow() const { return m_shadow; }
    /// Sets sun, sky, fog and exposure, and for lib/shadow_trace.glsl position and extent of the shadow volume.
    void describe(FrameBlock& block) const;
    /// Where shadow casters have changed since the moment before.
    const DirtyRegions& dirtyRegions() const { return m_shownDirtyRegions; }
    /// What looks different, or gets other light from sun and sky, than in the moment before.
    const LookChanges& lookChanges() const { return m_lookChanges; }
    /// Whether any shape has a palette entry of opacity < 255.
    bool hasGlass() const { return m_bodies.hasGlass(); }
    /// A number that grows when shapes with glass, or the sun, have changed or moved.
    uint64_t glassChanges() const { return m_glassChanges; }
    /// Whether any shape has a palette entry smooth enough for reflection rays.
    bool hasMirrors() const { return m_bodies.hasMirrors(); }
    /// The point of the world that GPU coordinates are relative to: a corner of the shadow volume's sectors.
    glm::dvec3 origin() const { return m_origin; }
    /// GPU memory.
    uint64_t bytes() const {
        return m_bodies.bytes() + m_shadow.bytes() + m_smoke.bytes() + m_outlines.bytes() +
               (m_grid ? m_grid->bytes() : 0);
    }

private:
    bool isGlass(ShapeHandle shape) const;
    bool touchesGlass(const FrameSnapshot& snapshot) const;
    struct Deferred {
        FrameSnapshot snapshot;
        uint64_t bricksSent;  ///< Bodies::bricksSent() from which on it can be applied
    };
    void describeShadow(FrameBlock& block) const;
    /// Keeps the snapshot's lists of bricks.
    void applyNow(FrameSnapshot& snapshot);
    void applyDeferred();
    uint64_t updateGrid();

    Bodies m_bodies;
    std::optional<BodyGrid> m_grid;  ///< while anything needs bindVoxelsAt()
    bool m_bounceColors = false;
    std::deque<Deferred> m_deferred;  ///< oldest first
    uint64_t m_uploadBudget = ~uint64_t(0);
    bool m_sendAll = false;  ///< a level was loaded: the next frame ignores the budget
    GpuShadowVolume m_shadow;
    DirtyRegions m_dirtyRegions;       ///< of the moment to come
    DirtyRegions m_shownDirtyRegions;  ///< of the moment that is drawn
    LookChanges m_lookChanges;
    SmokeShadow m_smoke;
    std::vector<SnapshotLight> m_lights;
    std::vector<SnapshotParticle> m_particles;
    std::vector<SnapshotRope> m_ropes;
    std::vector<Water> m_waters;
    WaterOutlines m_outlines;
    std::vector<SnapshotRipple> m_ripples;
    double m_seconds = 0.0;
    uint64_t m_glassChanges = 0;
    bool m_smokeChanged = false, m_watersChanged = false;
    Environment m_environment;
    glm::dvec3 m_origin{0.0};
};

}  // namespace rubble
