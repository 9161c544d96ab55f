#include "runtime/frame/snapshot_merger.h"

#include <algorithm>

namespace rubble {

void SnapshotMerger::add(FrameSnapshot&& later) {
    if (!m_all || later.replacesAll) {
        *this = {};
        m_all = std::move(later);
        return;
    }
    sort();
    m_all->version = std::max(m_all->version, later.version);
    m_all->newestStep = std::max(m_all->newestStep, later.newestStep);
    if (!later.materials.empty()) m_all->materials = std::move(later.materials);
    for (const ShapeHandle shape : later.destroyed) destroy(shape);
    for (SnapshotShape& shape : later.created) {
        const ShapeHandle handle = shape.shape;
        ByBrick<BrickChange> bricks(std::exchange(shape.bricks, {}));
        m_created.set({handle, std::move(shape), std::move(bricks)});
    }
    for (BrickChange& brick : later.bricks) addBrick(std::move(brick));
    for (SnapshotPalette& palette : later.palettes) addPalette(std::move(palette));
    for (SnapshotPose& pose : later.poses) m_poses.set(std::move(pose));
    if (later.shadowReplacesAll) {
        m_all->shadowReplacesAll = true;
        m_shadow.take();
    }
    for (ShadowPatch& patch : later.shadow) addShadow(std::move(patch));
    addLists(later);
}

/// Makes the lists in which things are found, out of the first snapshot.
void SnapshotMerger::sort() {
    if (m_isSorted) return;
    m_isSorted = true;
    FrameSnapshot first = std::move(*m_all);
    const auto take = [](auto& list) { return std::exchange(list, {}); };
    for (SnapshotShape& shape : first.created) {
        const ShapeHandle handle = shape.shape;
        ByBrick<BrickChange> bricks(take(shape.bricks));
        m_created.set({handle, std::move(shape), std::move(bricks)});
    }
    for (BrickChange& brick : take(first.bricks)) addBrick(std::move(brick));
    m_palettes = ByShape<SnapshotPalette>(take(first.palettes));
    m_poses = ByShape<SnapshotPose>(take(first.poses));
    std::vector<ShadowPatch> shadow = take(first.shadow);
    first.created.clear();
    m_all = std::move(first);
    for (ShadowPatch& patch : shadow) addShadow(std::move(patch));
}

/// Drops all that concerns a shape. One that was to be created is not listed as destroyed: the receiver has never seen
/// it.
void SnapshotMerger::destroy(ShapeHandle shape) {
    if (m_created.find(shape))
        m_created.erase(shape);
    else
        m_all->destroyed.push_back(shape);
    m_bricks.erase(shape);
    m_palettes.erase(shape);
    m_poses.erase(shape);
}

void SnapshotMerger::addBrick(BrickChange&& change) {
    if (Created* created = m_created.find(change.shape)) {
        if (!change.content) return created->bricks.erase(change.brick);
        created->bricks.set(std::move(change));
        return;
    }
    ShapeBricks* shape = m_bricks.find(change.shape);
    if (!shape) shape = &m_bricks.set({change.shape, {}});
    shape->bricks.set(std::move(change));
}

void SnapshotMerger::addPalette(SnapshotPalette&& palette) {
    if (Created* created = m_created.find(palette.shape)) {
        created->content.palette = std::move(palette.palette);
        created->content.paintColors = std::move(palette.paintColors);
    } else {
        m_palettes.set(std::move(palette));
    }
}

/// A patch of what the receiver has never seen is dropped when it is empty again. Such patches would grow with the way
/// that bodies move, not with what is there.
void SnapshotMerger::addShadow(ShadowPatch&& patch) {
    ShadowPatch* earlier = m_shadow.find(patch.brick);
    const bool wasEmpty = earlier ? earlier->wasEmpty : patch.wasEmpty;
    if (!patch.content && (wasEmpty || m_all->shadowReplacesAll)) return m_shadow.erase(patch.brick);
    if (earlier) {
        earlier->content = std::move(patch.content);
        earlier->change.words |= patch.change.words;
        earlier->change.cells = std::min(earlier->change.cells + patch.change.cells, ShadowChange{}.cells);
    } else {
        m_shadow.set(std::move(patch));
    }
}

/// What a snapshot holds all of, or nothing.
void SnapshotMerger::addLists(FrameSnapshot& later) {
    const auto replace = [&](bool FrameSnapshot::*changed, auto FrameSnapshot::*list) {
        if (!(later.*changed)) return;
        (*m_all).*changed = true;
        (*m_all).*list = std::move(later.*list);
    };
    replace(&FrameSnapshot::lightsChanged, &FrameSnapshot::lights);
    replace(&FrameSnapshot::particlesChanged, &FrameSnapshot::particles);
    replace(&FrameSnapshot::ropesChanged, &FrameSnapshot::ropes);
    replace(&FrameSnapshot::watersChanged, &FrameSnapshot::waters);
    replace(&FrameSnapshot::ripplesChanged, &FrameSnapshot::ripples);
    replace(&FrameSnapshot::environmentChanged, &FrameSnapshot::environment);
}

std::optional<FrameSnapshot> SnapshotMerger::take() {
    std::optional<FrameSnapshot> out = std::exchange(m_all, {});
    if (!m_isSorted) return out;
    m_isSorted = false;
    for (Created& created : m_created.take()) {
        created.content.bricks = created.bricks.take();
        out->created.push_back(std::move(created.content));
    }
    for (ShapeBricks& shape : m_bricks.take())
        for (BrickChange& brick : shape.bricks.take()) out->bricks.push_back(std::move(brick));
    out->palettes = m_palettes.take();
    out->poses = m_poses.take();
    out->shadow = m_shadow.take();
    return out;
}

void merge(FrameSnapshot& into, FrameSnapshot&& later) {
    SnapshotMerger merger;
    merger.add(std::move(into));
    merger.add(std::move(later));
    into = *merger.take();
}

}  // namespace rubble
