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

/// Each once, shapes that are there and were before, if each time that they came to be in `destroyed`, a list as it was
/// before keepNet(), they had only moved.
void keepRelocated(FrameChanges& changes, std::vector<ShapeHandle> destroyed, const WorldObjects& after) {
    std::vector<ShapeHandle> known = changes.shapesDestroyed, moved = std::move(changes.relocated);
    for (auto* list : {&known, &moved, &destroyed}) std::sort(list->begin(), list->end());
    const auto countIn = [](const std::vector<ShapeHandle>& list, ShapeHandle shape) {
        return std::upper_bound(list.begin(), list.end(), shape) - std::lower_bound(list.begin(), list.end(), shape);
    };
    changes.relocated.clear();
    for (size_t i = 0; i < moved.size(); ++i)
        if ((i == 0 || moved[i] != moved[i - 1]) && after.shapes.find(moved[i]) && countIn(known, moved[i]) &&
            countIn(moved, moved[i]) == countIn(destroyed, moved[i]))
            changes.relocated.push_back(moved[i]);
}

}  // namespace

void keepNetChanges(FrameChanges& changes, const WorldObjects& after) {
    keepNet(changes.bodiesCreated, changes.bodiesDestroyed, after.bodies);
    std::vector<ShapeHandle> destroyed;
    if (!changes.relocated.empty()) destroyed = changes.shapesDestroyed;
    keepNet(changes.shapesCreated, changes.shapesDestroyed, after.shapes);
    if (!changes.relocated.empty()) keepRelocated(changes, std::move(destroyed), after);
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
