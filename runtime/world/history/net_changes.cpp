#include "runtime/world/history/net_changes.h"

#include <algorithm>
#include <vector>

namespace rubble {
namespace {

/// What happened to an object of which both lists may tell. They take turns: it was there before the step if it is
/// there now and was not created more often than destroyed, or if it is gone and was destroyed more often.
template <class Handle>
struct Fate {
    Handle handle;
    int created = 0, destroyed = 0;
    bool isAlive = false;
    bool wasThere() const { return int(isAlive) + destroyed > created; }
};

template <class Handle, class Map>
void keepNet(std::vector<Handle>& created, std::vector<Handle>& destroyed, const Map& after) {
    if (created.empty() || destroyed.empty()) return;
    std::vector<Fate<Handle>> fates;
    fates.reserve(created.size() + destroyed.size());
    for (const auto* list : {&created, &destroyed})
        for (const Handle handle : *list) fates.push_back({handle});
    const auto isBefore = [](const auto& a, const auto& b) { return a.handle < b.handle; };
    const auto isSame = [](const auto& a, const auto& b) { return a.handle == b.handle; };
    std::sort(fates.begin(), fates.end(), isBefore);
    fates.erase(std::unique(fates.begin(), fates.end(), isSame), fates.end());
    const auto fateOf = [&](Handle handle) -> Fate<Handle>& {
        return *std::lower_bound(fates.begin(), fates.end(), Fate<Handle>{handle}, isBefore);
    };
    for (const Handle handle : created) ++fateOf(handle).created;
    for (const Handle handle : destroyed) ++fateOf(handle).destroyed;
    // `created` and `destroyed` now say whether the object still has to be listed.
    for (Fate<Handle>& fate : fates) {
        fate.isAlive = after.find(fate.handle);
        const bool wasThere = fate.wasThere();
        fate.created = fate.isAlive, fate.destroyed = wasThere;
    }
    std::erase_if(created, [&](Handle handle) { return fateOf(handle).created-- <= 0; });
    std::erase_if(destroyed, [&](Handle handle) { return fateOf(handle).destroyed-- <= 0; });
}

/// Those that are there and were before, each once.
void keepRelocated(FrameChanges& changes, const WorldObjects& after) {
    std::vector<ShapeHandle>& all = changes.relocated;
    if (all.empty()) return;
    std::vector<ShapeHandle> known = changes.shapesDestroyed;
    std::sort(known.begin(), known.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::erase_if(all, [&](ShapeHandle shape) {
        return !after.shapes.find(shape) || !std::binary_search(known.begin(), known.end(), shape);
    });
}

}  // namespace

void keepNetChanges(FrameChanges& changes, const WorldObjects& after) {
    keepNet(changes.bodiesCreated, changes.bodiesDestroyed, after.bodies);
    keepNet(changes.shapesCreated, changes.shapesDestroyed, after.shapes);
    keepRelocated(changes, after);
    const auto isBodyGone = [&](BodyHandle body) { return !after.bodies.find(body); };
    const auto isShapeGone = [&](ShapeHandle shape) { return !after.shapes.find(shape); };
    std::erase_if(changes.impulses, [&](const ImpulseApplied& each) { return isBodyGone(each.body); });
    for (auto* list : {&changes.settled, &changes.unsettled, &changes.woken, &changes.teleported, &changes.broken,
                       &changes.lostShapes})
        std::erase_if(*list, isBodyGone);
    for (auto* list : {&changes.unanchored, &changes.palettes, &changes.carved, &changes.filters})
        std::erase_if(*list, isShapeGone);
    std::erase_if(changes.bricks, [&](const BrickChange& each) { return isShapeGone(each.shape); });
    for (ShapeSplit& split : changes.splits) {
        size_t kept = 0;
        for (size_t i = 0; i < split.children.size(); ++i) {
            if (isShapeGone(split.children[i])) continue;
            split.children[kept] = split.children[i];
            split.parentOffset[kept] = split.parentOffset[i];
            split.motions[kept++] = split.motions[i];
        }
        split.children.resize(kept);
        split.parentOffset.resize(kept);
        split.motions.resize(kept);
    }
    std::erase_if(changes.splits, [](const ShapeSplit& split) { return split.children.empty(); });
}

}  // namespace rubble
