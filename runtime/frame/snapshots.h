#pragma once
#include <deque>
#include <optional>
#include <span>

#include "runtime/core/mailbox.h"
#include "runtime/frame/frame_snapshot.h"
#include "runtime/world/world.h"

namespace rubble {

/// Turns the journal into snapshots for the renderer. A step's snapshot waits until the shadow volume has reached that
/// step and is then posted together with the volume's patches: what is drawn is one version of the world throughout.
class Snapshots {
public:
    /// [main-thread] `moved` are the poses that physics has just handed over. Never waits.
    void publish(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world, std::vector<ShadowPatches> patches);
    /// [render-thread] All posted snapshots merged into one, or nothing.
    std::optional<FrameSnapshot> take();

private:
    std::deque<FrameSnapshot> m_waiting;   ///< steps whose shadow is not there yet, oldest first
    Mailbox<FrameSnapshot> m_posted;
};

}  // namespace rubble
