#include "tests/benchmark/world_rays/world_bits.h"

#include "runtime/shadow/shadow_worker.h"
#include "runtime/world/world.h"

namespace rubble::rays {

WorldBits bitsOf(const std::vector<ShadowPatch>& patches) {
    WorldBits out;
    glm::ivec3 low(1 << 30), high(-(1 << 30));
    for (const ShadowPatch& patch : patches) {
        if (!patch.content) continue;
        low = glm::min(low, patch.brick);
        high = glm::max(high, patch.brick + 1);
    }
    out.low = low * kShadowBrickCells;
    out.words = (high - low) * 4;
    out.bits.assign(size_t(out.words.x) * size_t(out.words.y) * size_t(out.words.z), 0);
    for (const ShadowPatch& patch : patches)
        for (int i = 0; patch.content && i < 64; ++i)
            out.bits[out.wordAt((patch.brick - low) * 4 + glm::ivec3(i & 3, i >> 2 & 3, i >> 4))] =
                patch.content->cells(i);
    return out;
}

std::vector<ShadowPatch> patchesOf(const Level& level) {
    World world;
    world.load(level);
    FrameChanges changes = world.applyEdits({});
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    worker.submit(changes, {}, world);
    std::vector<ShadowPatch> out;
    for (ShadowPatches& publication : worker.takePatches())
        out.insert(out.end(), publication.patches.begin(), publication.patches.end());
    return out;
}

}  // namespace rubble::rays
