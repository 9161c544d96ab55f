// Edits: random sequences with wild numbers, on a world with its physics, as the frame loop steps it.
#include <cstdio>
#include <cstdlib>

#include "physics/physics_world.h"
#include "runtime/world/impacts/break_through.h"
#include "runtime/world/impacts/impact_damage.h"
#include "tests/fuzz/random_world.h"
#include "tests/fuzz/stages.h"

namespace rubble {

void fuzz(Decisions& decisions) {
    World world;
    PhysicsWorld physics;
    world.load(randomLevel(decisions));
    Edits damage;
    const uint32_t wildness = decisions.oneIn(3) ? 0 : 1u << decisions.below(7);
    for (uint32_t step = 2 + decisions.below(10); step-- > 0;) {
        Edits edits = std::exchange(damage, {});
        for (uint32_t i = decisions.below(4); i-- > 0;) edits.push_back(randomEdit(decisions, world, wildness));
        if (world.data().levelReplaced || decisions.oneIn(20)) physics.load(world);
        const FrameChanges changes = world.applyEdits(edits);
        physics.apply(changes, world);
        reached("steps");
        if (!changes.empty()) reached("steps with changes");
        physics.step();
        copyMotion(physics, world);
        damage = impactDamage(world, physics.impacts());
        addBreakThroughImpulses(world, physics.impacts(), damage);
        for (const JointHandle joint : physics.jointBreaks())
            damage.emplace_back(RemoveJointEdit{joint, JointBreak::Force});
    }
    const VoxelAccounting sums = voxelAccounting(world);
    if (!sums.balances()) {
        std::fprintf(stderr, "voxels are lost or made\n");
        std::abort();
    }
    requireReadableSave(world);
}

}  // namespace rubble
