#pragma once
#include <memory>
#include <vector>

#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/demolition.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/town.h"

namespace rubble::bench {

/// A camera in the sandbox town.
struct TownView {
    const char* name;
    Pose camera;
    float verticalFov;
    /// For a frame of `size` pixels into a framebuffer.
    View view(glm::ivec2 size, unsigned framebuffer) const {
        View v;
        v.position = camera.position;
        v.rotation = camera.rotation;
        v.verticalFov = verticalFov;
        v.size = size;
        v.framebuffer = framebuffer;
        return v;
    }
};

/// The three views that benchmarks share.
inline std::vector<TownView> townViews() {
    return {{"corner", demolitionCamera(2.0), kDemolitionFov},
            {"street", scenes::lookAt({9.0, 1.7, 47.0}, {40.0, 2.0, 30.0}), 1.05f},
            {"map view", scenes::lookAt({32.0, 62.0, 58.0}, {32.0, 0.0, 32.0}), 0.70f}};
}

/// The sandbox town after two seconds of demolition, with its shadow volume.
inline std::unique_ptr<FrameLoop> playTown() {
    FrameLoopSettings settings;
    settings.shadow = ShadowWorker::Mode::Inline;
    settings.waitForShadow = true;
    auto loop = std::make_unique<FrameLoop>(settings);
    loop->load(makeTown(1));
    for (int i = 0; i < 120; ++i) {
        loop->edits().push(demolition(i, 1));
        loop->step();
    }
    return loop;
}

}  // namespace rubble::bench
