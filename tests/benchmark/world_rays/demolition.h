#pragma once
#include <array>
#include <map>
#include <vector>

#include "runtime/core/random.h"
#include "runtime/shadow/shadow_worker.h"
#include "runtime/world/world.h"
#include "tests/benchmark/world_rays/scenes.h"

namespace rubble::rays {

/// A scene's world with additional cubes of 8^3 to 32^3 voxels, which is carved while the cubes move at random.
class Demolition {
public:
    /// Adds `bodies` cubes at random positions.
    Demolition(const RayScene& scene, int bodies);
    /// One step with some random carves; moving: the cubes move too.
    void step(int carves, bool moving);
    /// The patches that the shadow worker has published since the last call.
    std::vector<ShadowPatch> takePatches();
    /// All bricks as published.
    std::vector<ShadowPatch> patchesNow() const;
    /// All bricks as they would be published if nothing moved, with the largest empty boxes.
    std::vector<ShadowPatch> patchesAtRest() const;
    /// The present volume in a box of its own, as cubes may leave the scene's.
    WorldBits bits() const;
    /// Median processor milliseconds of the shadow worker over the last `steps`.
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
