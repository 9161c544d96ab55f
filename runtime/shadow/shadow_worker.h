#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "runtime/shadow/shadow_volume.h"
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/world.h"

namespace rubble {

/// Whether a step can change the shadow volume. A version is published for each step that can, or for a later one that
/// includes it, and for no other.
inline bool changesShadow(const FrameChanges& changes, std::span<const BodyPose> moved) {
    return changes.levelReplaced || !changes.shapesCreated.empty() || !changes.shapesDestroyed.empty() ||
           !changes.bricks.empty() || !changes.palettes.empty() || !moved.empty();
}

/// Keeps the shadow volume up to date, on its own thread or inline, from a copy of the world's shapes that shares their
/// bricks. [main-thread] All calls but takePatches(), which any thread may make.
class ShadowWorker {
public:
    enum class Mode { Thread, Inline };
    /// Thread: starts a thread; where there are none it is as Inline. Inline: submit() does the work itself, for tests
    /// and single-threaded hosts. onProgress: called on the worker's thread before each piece of its work, a shape or a
    /// brick; for tests.
    explicit ShadowWorker(Mode mode, std::function<void()> onProgress = {});
    ~ShadowWorker();  ///< does not wait for queued steps
    ShadowWorker(const ShadowWorker&) = delete;
    ShadowWorker& operator=(const ShadowWorker&) = delete;

    /// Queues what this step changed: bricks by reference, the poses of the bodies in `moved`. Never waits.
    void submit(const FrameChanges& changes, std::span<const BodyPose> moved, const World& world);
    /// What was published since the last call, oldest first; each publication is one version.
    std::vector<ShadowPatches> takePatches();
    /// Waits until `version` is published: for tests, benchmarks and images that must not depend on timing.
    void waitFor(uint64_t version);
    /// The step whose world the published volume equals. Steps that change nothing for shadows count at once.
    uint64_t publishedVersion() const;
    /// How many steps the published volume was behind the last step when that was submitted.
    uint64_t lag() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace rubble
