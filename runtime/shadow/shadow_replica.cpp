#include "runtime/shadow/shadow_replica.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/core/planted_fault.h"
#include "runtime/shadow/surface_bricks.h"

namespace rubble {
namespace {

template <class F>
void forEachCell(const CellBox& box, F&& f) {
    for (int z = box.low.z; z < box.high.z; ++z)
        for (int y = box.low.y; y < box.high.y; ++y)
            for (int x = box.low.x; x < box.high.x; ++x) f(glm::ivec3(x, y, z));
}

bool isBefore(glm::ivec3 a, glm::ivec3 b) {
    return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
}

BrickRef withoutTranslucent(const BrickRef& brick, const std::array<bool, 256>& entries) {
    if (!brick) return nullptr;
    if (!brick->indices) return entries[brick->uniform] ? brick : nullptr;
    std::array<uint64_t, 8> keep = brick->occupancy;
    forEachVoxel(brick->occupancy, [&](int i) {
        if (!entries[(*brick->indices)[size_t(i)]]) clearVoxel(keep, i);
    });
    return keep == brick->occupancy ? brick : maskBrick(*brick, keep);
}

VoxelGrid withoutTranslucent(const VoxelGrid& grid, const std::array<bool, 256>& entries) {
    VoxelGrid out = grid;
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        BrickRef opaque = withoutTranslucent(brick, entries);
        if (opaque != brick) out.setBrick(position, std::move(opaque));
    });
    return out;
}

void sortUnique(std::vector<glm::ivec3>& bricks) {
    std::sort(bricks.begin(), bricks.end(), isBefore);
    bricks.erase(std::unique(bricks.begin(), bricks.end()), bricks.end());
}

/// Lists the bricks of the volume in which a grid's voxels can set cells, in the order of isBefore().
void listBricks(const VoxelGrid& grid, const Pose& pose, double voxelSize, std::vector<glm::ivec3>& bricks) {
    constexpr size_t kFewBricks = 64;  // up to these the box around all of them is cheaper than each for itself
    const auto add = [&](glm::ivec3 brick) { bricks.push_back(brick); };
    bricks.clear();
    if (grid.brickCount() == 0) return;
    if (grid.brickCount() <= kFewBricks) {
        CellBox used{grid.size(), glm::ivec3(0)};
        grid.forEachBrick([&](glm::ivec3 position, const BrickRef&) {
            for (int a = 0; a < 3; ++a) {
                used.low[a] = std::min(used.low[a], position[a] * kBrickSize);
                used.high[a] = std::max(used.high[a], std::min(position[a] * kBrickSize + kBrickSize, grid.size()[a]));
            }
        });
        return forEachCell(shadowBricksOf(shadowBounds(pose, voxelSize, used)), add);
    }
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef&) {
        const CellBox box{position * kBrickSize, position * kBrickSize + kBrickSize};
        forEachCell(shadowBricksOf(shadowBounds(pose, voxelSize, box)), add);
    });
    sortUnique(bricks);
}

}  // namespace

size_t ShadowReplica::BrickHash::operator()(glm::ivec3 brick) const {
    const uint64_t h = uint64_t(uint32_t(brick.x)) * 0x9e3779b97f4a7c15ull ^
                       uint64_t(uint32_t(brick.y)) * 0xc2b2ae3d27d4eb4full ^
                       uint64_t(uint32_t(brick.z)) * 0x165667b19e3779f9ull;
    return size_t(h ^ h >> 29);
}

ShadowReplica::Shape* ShadowReplica::find(ShapeHandle handle) {
    if (handle.slot() >= m_shapes.size() || !m_shapes[handle.slot()]) return nullptr;
    return m_shapes[handle.slot()]->handle == handle ? m_shapes[handle.slot()].get() : nullptr;
}

void ShadowReplica::apply(ShadowStep&& step, const MustStop& mustStop) {
    if (step.replacesAll) {
        m_shapes.clear();
        m_brickStates.clear();
        m_members.clear();
        m_memberSlots = {};
        m_waiting.clear();
        m_touched.clear();
    }
    for (const ShapeHandle handle : step.destroyed) destroy(handle);
    for (ShadowStep::NewShape& shape : step.created) {
        if (mustStop()) return;
        create(std::move(shape));
    }
    for (const BrickChange& change : step.bricks)
        if (Shape* shape = find(change.shape); shape && !(isPlanted("skipped-shadow-patch") && change.brick.x % 2))
            setBrick(*shape, change);
    for (const ShadowStep::ShapePalette& palette : step.palettes)
        if (Shape* shape = find(palette.shape)) setPalette(*shape, *palette.palette);
    for (const ShadowStep::ShapePose& pose : step.poses)
        if (Shape* shape = find(pose.shape)) setPose(*shape, pose.pose, pose.asleep);
}

void ShadowReplica::create(ShadowStep::NewShape&& from) {
    destroy(from.shape);
    if (!m_pool) m_pool = std::make_shared<BlockPool>(kSpareBricks);
    auto shape = std::make_unique<Shape>();
    shape->handle = from.shape;
    shape->grid = std::move(from.grid);
    shape->voxelSize = from.voxelSize;
    shape->pose = from.pose;
    shape->entries.fill(true);
    Shape& placed = *shape;
    if (m_shapes.size() <= from.shape.slot()) m_shapes.resize(from.shape.slot() + 1);
    m_shapes[from.shape.slot()] = std::move(shape);
    setPalette(placed, *from.palette);
    queuePlacement(placed);
}

void ShadowReplica::destroy(ShapeHandle handle) {
    Shape* shape = find(handle);
    if (!shape) return;
    leaveAll(*shape);
    dropRaster(*shape);
    m_shapes[handle.slot()].reset();
}

void ShadowReplica::setBrick(Shape& shape, const BrickChange& change) {
    const BrickRef before = shape.casterGrid().shareBrick(change.brick);
    shape.grid.setBrick(change.brick, change.content);
    if (shape.hasTranslucent) shape.opaque.setBrick(change.brick, withoutTranslucent(change.content, shape.entries));
    const Brick* after = shape.casterGrid().brickAt(change.brick);
    const bool same = before && after ? before->occupancy == after->occupancy : !before && !after;
    if (same) return;
    shape.tiles = -1.0;
    shape.source.clear();
    if (!shape.placed) return;
    if (shape.raster.isMade()) return queuePlacement(shape);
    if (shape.voxelSize >= kSurfaceVoxelSize) return touchSurface(shape, change.brick);
    if (!shape.isQueued) touchVoxelBrick(shape, change.brick);
}

void ShadowReplica::setPalette(Shape& shape, const Palette& palette) {
    OpaqueEntries entries;
    for (size_t i = 0; i < entries.size(); ++i) entries[i] = palette[i].opacity >= kMinOpacity;
    if (entries == shape.entries) return;
    shape.entries = entries;
    shape.hasTranslucent = std::find(entries.begin(), entries.end(), false) != entries.end();
    shape.tiles = -1.0;
    shape.source.clear();
    shape.keepsCells = false;
    shape.opaque = shape.hasTranslucent ? withoutTranslucent(shape.grid, entries) : VoxelGrid();
    queuePlacement(shape);
}

void ShadowReplica::setPose(Shape& shape, const Pose& pose, bool asleep) {
    if (pose == shape.pose && shape.moving == !asleep) return;
    if (shape.moving == asleep) leaveAll(shape);
    shape.pose = pose;
    shape.moving = !asleep;
    shape.keepsCells = false;
    queuePlacement(shape);
}

void ShadowReplica::queuePlacement(Shape& shape) {
    if (shape.isQueued) return;
    shape.isQueued = true;
    m_waiting.push_back(shape.handle);
}

/// Builds m_nextRaster of a shape, empty if it rests or is large, and lists in m_bricks the bricks that it is in.
void ShadowReplica::rasterizeMoving(Shape& shape) {
    const VoxelGrid& grid = shape.casterGrid();
    const glm::ivec3 size = grid.size();
    bool made = shape.moving && std::max({size.x, size.y, size.z}) <= RasterSource::kMaxSize;
    if (made && !shape.source.isMade()) shape.source.make(grid);
    made = made && m_nextRaster.make(shape.source, shape.cellTransform, shape.bounds);
    m_bricks.clear();
    if (made) return m_nextRaster.forEach([&](glm::ivec3 brick, const ShadowWords&) { m_bricks.push_back(brick); });
    m_nextRaster.clear();
    shape.voxelSize >= kSurfaceVoxelSize ? listSurface(shape) : listBricks(grid, shape.pose, shape.voxelSize, m_bricks);
}

/// Lists in m_bricks the bricks in which the surface of a shape of large voxels is.
void ShadowReplica::listSurface(Shape& shape) {
    if (shape.tiles < 0.0) shape.tiles = surfaceTiles(shape.casterGrid(), shape.voxelSize);
    if (shape.tiles <= (shape.moving ? kMaxMovingTiles : kMaxSurfaceTiles)) {
        listSurfaceBricks(shape.casterGrid(), shape.pose, shape.voxelSize, m_bricks);
        return sortUnique(m_bricks);
    }
    if (!std::exchange(shape.isLargeLogged, true))
        logWarning("shadow volume: a shape with voxels of " + std::to_string(shape.voxelSize) +
                   " m is too large and casts no shadow" + (shape.tiles > kMaxSurfaceTiles ? "" : " while it moves") +
                   "; use smaller pieces, or fewer or smaller voxels");
}

void ShadowReplica::place(Shape& shape) {
    shape.isQueued = false;
    shape.placed = shape.grid.size().x > 0 && shape.cellTransform.place(shape.pose, shape.voxelSize);
    if (!shape.placed) {
        if (shape.grid.brickCount() > 0 && !std::exchange(m_isFarLogged, true))
            logWarning("shadow volume: a shape at " + std::to_string(shape.pose.position.x) + ", " +
                       std::to_string(shape.pose.position.y) + ", " + std::to_string(shape.pose.position.z) +
                       " m casts no shadow and is not seen in mirrors; expected each coordinate within 1e8 m");
        return leaveAll(shape);
    }
    shape.bounds = shadowBounds(shape.pose, shape.voxelSize, {glm::ivec3(0), shape.grid.size()});
    rasterizeMoving(shape);
    const bool keepsCells = std::exchange(shape.keepsCells, false);
    const auto changed = [&](glm::ivec3 brick) {
        if (keepsCells) return false;
        const ShadowWords *before = shape.raster.find(brick), *after = m_nextRaster.find(brick);
        return !before || !after || *before != *after;
    };
    // Walks the old list of bricks and the new one together; most bricks are in both.
    m_nextCovered.clear();
    auto old = shape.covered.begin();
    const auto oldEnd = shape.covered.end();
    for (const glm::ivec3 brick : m_bricks) {
        for (; old != oldEnd && isBefore((*old)->first, brick); ++old) leave(shape, **old);
        const bool stays = old != oldEnd && (*old)->first == brick;
        m_nextCovered.push_back(stays ? *old++ : enter(shape, brick));
        if (!stays || changed(brick)) touch(shape, *m_nextCovered.back());
    }
    for (; old != oldEnd; ++old) leave(shape, **old);
    shape.covered.assign(m_nextCovered.begin(), m_nextCovered.end());  // each keeps its own memory
    m_nextRaster.isMade() ? keepNextRaster(shape) : dropRaster(shape);
}

void ShadowReplica::keepNextRaster(Shape& shape) {
    std::swap(shape.raster, m_nextRaster);
    if (m_nextRaster.isMade() || m_spareRasters.empty()) return;
    m_nextRaster = std::move(m_spareRasters.back());
    m_spareRasters.pop_back();
}

void ShadowReplica::dropRaster(Shape& shape) {
    if (!shape.raster.isMade()) return;
    ShapeRaster dropped = std::exchange(shape.raster, ShapeRaster());
    if (m_spareRasters.size() < kSpareRasters) m_spareRasters.push_back(std::move(dropped));
}

ShadowReplica::BrickEntry* ShadowReplica::enter(const Shape& shape, glm::ivec3 brick) {
    auto found = m_brickStates.find(brick);
    if (found == m_brickStates.end() && !m_spares.empty()) {
        m_spares.back().key() = brick;
        found = m_brickStates.insert(std::move(m_spares.back())).position;
        m_spares.pop_back();
    } else if (found == m_brickStates.end()) {
        found = m_brickStates.try_emplace(brick).first;
    }
    BrickEntry& entry = *found;
    const uint32_t member = m_memberSlots.allocate();
    if (member == m_members.size()) m_members.emplace_back();
    m_members[member] = {shape.handle.slot(), std::exchange(listOf(shape, entry), member)};
    return &entry;
}

void ShadowReplica::leave(const Shape& shape, BrickEntry& entry) {
    uint32_t* link = &listOf(shape, entry);
    while (m_members[*link].slot != shape.handle.slot()) link = &m_members[*link].next;
    m_memberSlots.free(std::exchange(*link, m_members[*link].next));
    touch(shape, entry);
}

void ShadowReplica::leaveAll(Shape& shape) {
    for (BrickEntry* entry : shape.covered) leave(shape, *entry);
    shape.covered.clear();
}

void ShadowReplica::touch(const Shape& shape, BrickEntry& entry) {
    BrickState& state = entry.second;
    if (!shape.moving) state.isRestCurrent = false;
    if (state.touched) return;
    state.touched = true;
    m_touched.push_back(&entry);
}

void ShadowReplica::touchVoxelBrick(Shape& shape, glm::ivec3 voxelBrick) {
    const CellBox box{voxelBrick * kBrickSize, voxelBrick * kBrickSize + kBrickSize};
    forEachCell(shadowBricksOf(shadowBounds(shape.pose, shape.voxelSize, box)), [&](glm::ivec3 brick) {
        const auto isEntryBefore = [](const BrickEntry* entry, glm::ivec3 b) { return isBefore(entry->first, b); };
        auto at = std::lower_bound(shape.covered.begin(), shape.covered.end(), brick, isEntryBefore);
        if (at == shape.covered.end() || (*at)->first != brick) at = shape.covered.insert(at, enter(shape, brick));
        touch(shape, **at);
    });
}

/// Of a shape of large voxels. Its surface is elsewhere now, so that it is placed again; of the bricks that it stays
/// in, only those beside the voxels change.
void ShadowReplica::touchSurface(Shape& shape, glm::ivec3 voxelBrick) {
    const CellBox box{voxelBrick * kBrickSize, voxelBrick * kBrickSize + kBrickSize};
    const CellBox near = shadowBricksOf(shadowBounds(shape.pose, shape.voxelSize, box));
    for (BrickEntry* entry : shape.covered)
        if (near.contains(entry->first)) touch(shape, *entry);
    if (!shape.isQueued) shape.keepsCells = true;
    queuePlacement(shape);
}

ShadowBrickRef ShadowReplica::buildResting(const BrickState& state, glm::ivec3 brick) const {
    if (state.resting == kNone) return nullptr;
    CellRows rows{};
    for (uint32_t member = state.resting; member != kNone; member = m_members[member].next) {
        const Shape& shape = *m_shapes[m_members[member].slot];
        rasterize(shape.casterGrid(), shape.cellTransform, shape.bounds, brick, rows);
    }
    const ShadowWords cells = packRows(rows);
    const bool isSame = state.published && !state.isTransient && sameCells(*state.published, cells);
    return isSame ? state.published : makeShadowBrick(cells, false, m_pool);
}

/// The cells of all shapes; those of resting ones from `rest`.
ShadowWords ShadowReplica::cellsOf(const BrickState& state, glm::ivec3 brick) const {
    ShadowWords cells{};
    if (state.rest)
        for (int i = 0; i < 64; ++i) cells[size_t(i)] = state.rest->cells(i);
    const auto add = [&](const ShadowWords& others) {
        for (size_t i = 0; i < cells.size(); ++i) cells[i] |= others[i];
    };
    for (uint32_t member = state.moving; member != kNone; member = m_members[member].next) {
        const Shape& shape = *m_shapes[m_members[member].slot];
        if (const ShadowWords* words = shape.raster.find(brick)) {
            add(*words);
        } else if (!shape.raster.isMade()) {
            CellRows rows{};
            rasterize(shape.casterGrid(), shape.cellTransform, shape.bounds, brick, rows);
            add(packRows(rows));
        }
    }
    return cells;
}

/// The present content of a brick: the published object where that holds the same cells.
ShadowBrickRef ShadowReplica::currentContent(BrickState& state, glm::ivec3 brick) const {
    if (!state.isRestCurrent) state.rest = buildResting(state, brick);
    state.isRestCurrent = true;
    if (state.moving == kNone) return state.rest;  // without moving shapes; its empty boxes are larger
    const ShadowWords cells = cellsOf(state, brick);
    return state.published && sameCells(*state.published, cells) ? state.published
                                                                 : makeShadowBrick(cells, true, m_pool);
}

void ShadowReplica::rebuildBrick(BrickEntry& entry, ShadowPatches& out) {
    auto& [brick, state] = entry;
    ShadowBrickRef content = currentContent(state, brick);
    state.isTransient = state.moving != kNone;
    if (content == state.published) return;
    const bool wasEmpty = !state.published;
    const ShadowChange change = changeBetween(state.published.get(), content.get());
    state.published = std::move(content);
    out.patches.push_back({brick, state.published, wasEmpty, change});
}

bool ShadowReplica::update(ShadowPatches& out, const MustStop& mustStop) {
    for (const ShapeHandle handle : m_waiting) {
        if (mustStop()) return false;
        if (Shape* shape = find(handle)) place(*shape);
    }
    m_waiting.clear();
    out.patches.reserve(out.patches.size() + m_touched.size());
    for (BrickEntry* entry : m_touched) {
        if (mustStop()) return false;
        entry->second.touched = false;
        rebuildBrick(*entry, out);
        if (entry->second.resting != kNone || entry->second.moving != kNone) continue;
        auto empty = m_brickStates.extract(glm::ivec3(entry->first));
        if (m_spares.size() < kSpareBricks) m_spares.push_back(std::move(empty));
    }
    m_touched.clear();
    return true;
}

}  // namespace rubble
