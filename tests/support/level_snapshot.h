#pragma once
#include "runtime/frame/snapshots.h"
#include "runtime/shadow/shadow_worker.h"
#include "runtime/world/world.h"

namespace rubble {

/// The first frame of a level, with its shadow volume.
inline FrameSnapshot levelSnapshot(const Level& level) {
    World world;
    world.load(level);
    const FrameChanges changes = world.applyEdits({});
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    worker.submit(changes, {}, world);
    Snapshots snapshots;
    snapshots.publish(changes, {}, world, worker.takePatches());
    return std::move(*snapshots.take());
}

}  // namespace rubble
