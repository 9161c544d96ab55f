#include <algorithm>
#include <unordered_map>

#include "runtime/core/hash.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {
namespace {

struct BrickKey {
    ShapeHandle shape;
    glm::ivec3 brick;
    friend bool operator==(const BrickKey&, const BrickKey&) = default;
};
struct BrickKeyHash {
    size_t operator()(const BrickKey& place) const {
        return hashBytes(&place.brick, sizeof place.brick, place.shape.bits);
    }
};

ShapeHandle keyOf(const SnapshotShape& v) {
    return v.shape;
}
ShapeHandle keyOf(const SnapshotPose& v) {
    return v.shape;
}
ShapeHandle keyOf(const SnapshotPalette& v) {
    return v.shape;
}
BrickKey keyOf(const BrickChange& v) {
    return {v.shape, v.brick};
}
BrickKey keyOf(const ShadowPatch& v) {
    return {{}, v.brick};
}

template <class T>
void replace(T& earlier, T&& later) {
    earlier = std::move(later);
}
void replace(ShadowPatch& earlier, ShadowPatch&& later) {
    earlier.content = std::move(later.content);  // what was there before the earlier one stays known
}

/// The later value of a key takes the earlier one's place; new keys follow in their order.
template <class Hash, class T>
void mergeByKey(std::vector<T>& into, std::vector<T>&& later) {
    if (into.empty()) {
        into = std::move(later);
        return;
    }
    if (later.empty()) return;
    std::unordered_map<decltype(keyOf(into[0])), size_t, Hash> places;
    places.reserve(into.size());
    for (size_t i = 0; i < into.size(); ++i) places.emplace(keyOf(into[i]), i);
    for (T& value : later) {
        const auto place = places.find(keyOf(value));
        if (place == places.end())
            into.push_back(std::move(value));
        else
            replace(into[place->second], std::move(value));
    }
}

using ShapeHash = std::hash<ShapeHandle>;
using ShapePlaces = std::unordered_map<ShapeHandle, size_t>;

/// Drops all that concerns destroyed shapes. Those that `into` was to create are not listed as destroyed either: the
/// receiver has never seen them.
void mergeDestroyed(FrameSnapshot& into, const std::vector<ShapeHandle>& destroyed) {
    if (destroyed.empty()) return;
    ShapePlaces gone;
    for (const ShapeHandle shape : destroyed) gone.emplace(shape, 0);
    ShapePlaces unseen;
    for (const SnapshotShape& shape : into.created) unseen.emplace(shape.shape, 0);
    const auto isGone = [&](const auto& value) { return gone.contains(value.shape); };
    std::erase_if(into.created, isGone);
    std::erase_if(into.bricks, isGone);
    std::erase_if(into.palettes, isGone);
    std::erase_if(into.poses, isGone);
    for (const ShapeHandle shape : destroyed)
        if (!unseen.contains(shape)) into.destroyed.push_back(shape);
}

/// Moves bricks and palettes of `later` into the shapes that `into` creates; those of other shapes stay in `later`.
void mergeIntoCreated(FrameSnapshot& into, FrameSnapshot& later) {
    if (into.created.empty() || (later.bricks.empty() && later.palettes.empty())) return;
    ShapePlaces created;
    for (size_t i = 0; i < into.created.size(); ++i) created.emplace(into.created[i].shape, i);

    std::vector<std::vector<BrickChange>> bricksOf(into.created.size());
    std::vector<BrickChange> otherBricks;
    for (BrickChange& brick : later.bricks) {
        const auto place = created.find(brick.shape);
        (place == created.end() ? otherBricks : bricksOf[place->second]).push_back(std::move(brick));
    }
    later.bricks = std::move(otherBricks);
    for (size_t i = 0; i < bricksOf.size(); ++i) {
        if (bricksOf[i].empty()) continue;
        mergeByKey<BrickKeyHash>(into.created[i].bricks, std::move(bricksOf[i]));
        std::erase_if(into.created[i].bricks, [](const BrickChange& brick) { return !brick.content; });
    }
    std::vector<SnapshotPalette> otherPalettes;
    for (SnapshotPalette& palette : later.palettes) {
        const auto place = created.find(palette.shape);
        if (place == created.end()) {
            otherPalettes.push_back(std::move(palette));
            continue;
        }
        into.created[place->second].palette = std::move(palette.palette);
        into.created[place->second].paintColors = std::move(palette.paintColors);
    }
    later.palettes = std::move(otherPalettes);
}

}  // namespace

void merge(FrameSnapshot& into, FrameSnapshot&& later) {
    if (later.replacesAll) {
        into = std::move(later);
        return;
    }
    into.version = std::max(into.version, later.version);
    into.newestStep = std::max(into.newestStep, later.newestStep);
    mergeDestroyed(into, later.destroyed);
    mergeIntoCreated(into, later);
    mergeByKey<ShapeHash>(into.created, std::move(later.created));
    mergeByKey<BrickKeyHash>(into.bricks, std::move(later.bricks));
    mergeByKey<ShapeHash>(into.palettes, std::move(later.palettes));
    mergeByKey<ShapeHash>(into.poses, std::move(later.poses));
    if (later.lightsChanged) {
        into.lightsChanged = true;
        into.lights = std::move(later.lights);
    }
    if (later.particlesChanged) {
        into.particlesChanged = true;
        into.particles = std::move(later.particles);
    }
    if (later.ropesChanged) {
        into.ropesChanged = true;
        into.ropes = std::move(later.ropes);
    }
    if (later.watersChanged) {
        into.watersChanged = true;
        into.waters = std::move(later.waters);
    }
    if (later.ripplesChanged) {
        into.ripplesChanged = true;
        into.ripples = std::move(later.ripples);
    }
    if (later.environmentChanged) {
        into.environmentChanged = true;
        into.environment = later.environment;
    }
    if (later.shadowReplacesAll) {
        into.shadowReplacesAll = true;
        into.shadow = std::move(later.shadow);
    } else {
        mergeByKey<BrickKeyHash>(into.shadow, std::move(later.shadow));
    }
    // The receiver has never seen these. They would grow with the way that bodies move, not with what is there.
    std::erase_if(into.shadow, [&](const ShadowPatch& patch) {
        return !patch.content && (patch.wasEmpty || into.shadowReplacesAll);
    });
}

}  // namespace rubble
