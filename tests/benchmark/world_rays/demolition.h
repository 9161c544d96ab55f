#pragma once
#include <map>

#include "runtime/core/random.h"
#include "runtime/shadow/shadow_worker.h"
#include "runtime/world/world.h"
#include "tests/benchmark/world_rays/scenes.h"

namespace rubble::rays {

/// A scene's world with cubes of 8^3 to 32^3 voxels in it, which is carved, and in which these fly about.
class Demolition {
public:
    Demolition(const RayScene& scene, int bodies);
    void step(int carves, bool moving);
    /// What the worker published since the last call.
    std::vector<ShadowPatch> takePatches();
    /// Every brick as it is, and as it would be if nothing moved.
    std::vector<ShadowPatch> patchesNow() const;
    std::vector<ShadowPatch> patchesAtRest() const;
    /// The volume now, in a box of its own: pieces reach out of the scene's.
    WorldBits bits() const;
    /// Median over the last `steps`, of this thread's processor time.
    double workerMs(size_t steps) const;

private:
    Random m_random{7};
    World m_world;
    ShadowWorker m_worker{ShadowWorker::Mode::Inline};
    std::vector<BodyHandle> m_movers;
    glm::dvec3 m_low, m_high;
    std::vector<double> m_times;
    std::vector<ShadowPatch> m_patches;
    std::map<std::array<int, 3>, ShadowBrickRef> m_bricks;
};

}  // namespace rubble::rays
