#include "samples/scenes/plot.h"

#include "runtime/core/random.h"
#include "samples/scenes/environment.h"
#include "samples/scenes/neighbourhood.h"
#include "samples/scenes/surface_styles.h"
#include "samples/scenes/tree.h"

namespace rubble::scenes {

Level makePlot(std::string name, const GroundPlan& ground, uint64_t seed) {
    Level level;
    level.name = std::move(name);
    level.environment = lateAfternoon();
    level.environment.sunDirection = {-0.74f, 0.40f, 0.40f};  // also shines on the sides that face the camera
    addGround(level, ground);
    Random random(seed, 31);
    static constexpr const SurfaceStyle* kCrowns[] = {&kLeaves, &kLeavesDark, &kLeavesAutumn, &kLeaves};
    for (int i = 0, x = 34; x < ground.size.x - 30; ++i) {
        const int height = random.between(62, 92);
        addTree(level, "tree " + std::to_string(i), {x, 0, 34 + random.between(0, 8)}, height, *kCrowns[i % 4],
                seed + uint64_t(i));
        x += random.between(58, 84);
    }
    addStatic(level, makeHedge("hedge", {ground.size.x - 24, 11, 9}), {12, -kHedgeRoot, 58});
    return level;
}

GroundPlan::Area area(GroundPlan::Surface surface, int x0, int z0, int x1, int z1) {
    return {surface, {{x0, 0, z0}, {x1, 0, z1}}};
}

}  // namespace rubble::scenes
