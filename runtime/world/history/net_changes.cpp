#include "runtime/world/history/net_changes.h"

#include <algorithm>
#include <map>

namespace rubble {
namespace {

/// What happened to an object of which both lists may tell. They take turns: it was there before the step if it is
/// there now and was not created more often than destroyed, or if it is gone and was destroyed more often.
struct Fate {
    int created = 0, destroyed = 0;
    bool isAlive = false;
    bool wasThere() const { return int(isAlive) + destroyed > created; }
};

template <class Handle, class Map>
void keepNet(std::vector<Handle>& created, std::vector<Handle>& destroyed, const Map& after) {
    if (created.empty() || destroyed.empty()) return;
    std::map<Handle, Fate> fates;
    for (const Handle handle : created) ++fates[handle].created;
    for (const Handle handle : destroyed) ++fates[handle].destroyed;
    for (auto& [handle, fate] : fates) fate.isAlive = after.find(handle);
    // `created` and `destroyed` now say whether the object still has to be listed.
    for (auto& [handle, fate] : fates) {
        const bool wasThere = fate.wasThere();
        fate.created = fate.isAlive, fate.destroyed = wasThere;
    }
    std::erase_if(created, [&](Handle handle) { return fates.at(handle).created-- <= 0; });
    std::erase_if(destroyed, [&](Handle handle) { return fates.at(handle).destroyed-- <= 0; });
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
