#pragma once
#include <list>

#include "render/frame/frame_camera.h"
#include "render/frame/target_pool.h"
#include "render/gl/gl_limits.h"

namespace rubble {

/// What the renderer keeps from frame to frame of the views of one slot and size.
struct ViewHistory {
    int slot = 0;
    glm::ivec2 size{0};      ///< pixels
    int leastDownscale = 0;  ///< how often the size must be halved for the GL to draw into it
    int downscale = 0;       ///< how often it is halved, because the GL had no room for more
    TargetPool targets;
    TargetPool exactTargets;  ///< the G-buffer at the displayed pixels, where a host's depth is composed with fewer
    TargetPool hostTargets;   ///< what the host has drawn, and the layers over it
    FrameCamera camera;
    /// GPU memory of all targets.
    uint64_t bytes() const { return targets.bytes() + exactTargets.bytes() + hostTargets.bytes(); }
    /// Whether the GL failed to make a target since the last clear().
    bool allocationFailed() const {
        return targets.allocationFailed() || exactTargets.allocationFailed() || hostTargets.allocationFailed();
    }
    /// Frees all targets.
    void clear() { targets.clear(), exactTargets.clear(), hostTargets.clear(); }
    uint64_t lastDraw = 0;      ///< number of the renderer's draw, from 1 on; 0: never
    double gameSeconds = 0.0;   ///< game time of the last draw
    uint64_t moment = 0;        ///< of the scene that it showed last
    uint64_t replacements = 0;  ///< of the scene at that moment
    uint64_t tryLargerAt = 0;   ///< number of the draw that tries the least downscale again
};

/// The histories of a renderer's views. Several views can be drawn in turn without making their targets again.
/// [render-thread]
class ViewHistories {
public:
    static constexpr int kMaxDownscale = 6;        ///< as a power of two: a side is at least 1/64 of the view's
    static constexpr size_t kSizes = 2;            ///< of a slot; a window that is resized shows many, but one at once
    static constexpr uint64_t kIdleDraws = 64;     ///< after which a history is freed
    static constexpr uint64_t kRetryDraws = 1024;  ///< with less than the least downscale, before it is tried again

    /// The history for the next draw, which is made if there is none. limits: of the GL.
    ViewHistory& begin(int slot, glm::ivec2 size, const GlLimits& limits);
    /// That of the last begin(); null: there was none.
    ViewHistory* last() { return m_all.empty() ? nullptr : &m_all.front(); }
    /// Frees all.
    void clear() { m_all.clear(); }
    /// GPU memory.
    uint64_t bytes() const;
    /// Number of histories held.
    size_t count() const { return m_all.size(); }

private:
    std::list<ViewHistory> m_all;  ///< drawn last first
    uint64_t m_draws = 0;
};

}  // namespace rubble
