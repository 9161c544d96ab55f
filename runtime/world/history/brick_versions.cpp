#include "runtime/world/history/brick_versions.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "runtime/voxel/brick_entries.h"
#include "runtime/voxel/used_entries.h"

namespace rubble {
namespace {

constexpr size_t kEntries = 256;  ///< of a palette

bool isDark(const LightGroup& group) {
    return group.out || group.off;
}

std::optional<Srgb> paintColorOf(const PaintColorsRef& colors, size_t index) {
    return colors ? std::optional(colors->colors[index]) : std::nullopt;
}

/// What of a shape looks otherwise.
struct Recolored {
    UsedEntries entries, paint;  ///< palette entries; paint colours, from 1 on
    bool isAnyPaint = false;

    bool isIn(const Brick& brick) const {
        bool found = false;
        forEachEntry(brick, brick.occupancy,
                     [&](uint8_t entry, size_t, uint64_t) { found = found || entries.contains(entry); });
        if (found || !isAnyPaint || !brick.paint) return found;
        return std::any_of(brick.paint->begin(), brick.paint->end(),
                           [&](uint8_t byte) { return paint.contains(size_t(paintColor(byte))); });
    }
};

}  // namespace

void BrickVersions::forget() {
    m_known.clear();
    m_isDark.clear();
    m_isAsked = false;
    m_first = ++m_version;
}

BrickVersions::Known& BrickVersions::known(ShapeHandle shape) {
    if (m_known.size() <= shape.slot()) m_known.resize(shape.slot() + 1);
    Known& found = m_known[shape.slot()];
    if (found.shape != shape) found = {shape};
    return found;
}

void BrickVersions::begin(const WorldData& world) {
    m_isAsked = true;
    world.groups.forEach([&](LightGroupHandle group, const LightGroup& each) {
        if (m_isDark.size() <= group.slot()) m_isDark.resize(group.slot() + 1);
        m_isDark[group.slot()] = isDark(each);
    });
    world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) { known(handle).colors = colorsOf(shape); });
}

void BrickVersions::follow(const FrameChanges& changes, const WorldData& world) {
    if (!m_isAsked) return;
    ++m_version;
    for (const ShapeHandle shape : changes.shapesDestroyed)
        if (!changes.isRelocated(shape)) known(shape) = {};
    for (const ShapeHandle shape : changes.shapesCreated)
        if (!changes.isRelocated(shape)) known(shape) = {shape, m_version, colorsOf(world.shapes.at(shape))};
    for (const BrickChange& change : changes.bricks)
        known(change.shape).bricks.add(BrickPlace(change.brick), m_version);
    for (const ShapeHandle handle : changes.palettes)
        if (const Shape* shape = world.shapes.find(handle)) followColors(known(handle), *shape);
    if (!changes.groups.empty()) followGroups(changes, world);
}

void BrickVersions::followColors(Known& known, const Shape& shape) {
    const Colors was = std::exchange(known.colors, colorsOf(shape));
    const bool glowsOtherwise = was.emission != shape.emission;
    for (size_t i = 1; i < kEntries; ++i) {
        const PaletteEntry& entry = (*shape.palette)[i];
        if (entry != (*was.palette)[i] || (glowsOtherwise && entry.emission > 0.0f))
            known.looks.add(uint16_t(i), m_version);
    }
    for (size_t i = 0; i < kPaintColors; ++i)
        if (paintColorOf(was.paint, i) != paintColorOf(shape.paintColors, i))
            known.looks.add(uint16_t(kEntries + i + 1), m_version);
}

/// A group that goes out, comes back or is switched changes the light of all voxels of it.
void BrickVersions::followGroups(const FrameChanges& changes, const WorldData& world) {
    std::vector<bool> switched;
    for (const LightGroupHandle handle : changes.groups) {
        const LightGroup* group = world.groups.find(handle);
        const size_t slot = handle.slot();
        if (m_isDark.size() <= slot) m_isDark.resize(slot + 1);
        const bool isDarkNow = group && isDark(*group);
        if (isDarkNow == m_isDark[slot]) continue;
        m_isDark[slot] = isDarkNow;
        if (switched.size() <= slot) switched.resize(slot + 1);
        switched[slot] = true;
    }
    if (switched.empty()) return;
    world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        for (size_t i = 1; i < kEntries; ++i) {
            const uint32_t group = (*shape.palette)[i].lightGroup;
            if (group && group <= switched.size() && switched[group - 1])
                known(handle).looks.add(uint16_t(i), m_version);
        }
    });
}

const std::vector<BrickPlace>* BrickVersions::changed(const WorldData& world, ShapeHandle handle, uint64_t since,
                                                      What what) {
    const VoxelGrid& grid = world.shapes.at(handle).grid;
    if (!m_isAsked) {
        if (since) return nullptr;
        begin(world);
    }
    m_found.clear();
    if (since == 0) {
        grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) { m_found.emplace_back(brick); });
        std::sort(m_found.begin(), m_found.end());
        return &m_found;
    }
    const Known& found = known(handle);
    if (since < std::max(m_first, found.made) || since > m_version) return nullptr;
    found.bricks.since(since, m_found);
    if (what != What::Mesh) return &m_found;
    addRecolored(grid, found, since);
    addNeighbours(grid.sizeInBricks());
    return &m_found;
}

/// Adds the bricks with voxels that look otherwise.
void BrickVersions::addRecolored(const VoxelGrid& grid, const Known& known, uint64_t since) {
    known.looks.since(since, m_looks);
    if (m_looks.empty()) return;
    Recolored recolored;
    for (const uint16_t look : m_looks)
        look < kEntries ? recolored.entries.insert(look) : recolored.paint.insert(look - kEntries);
    recolored.isAnyPaint = m_looks.back() >= kEntries;
    if (!recolored.isAnyPaint && !usedEntries(grid).intersects(recolored.entries)) return;
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        if (recolored.isIn(*brick)) m_found.emplace_back(position);
    });
}

/// Adds the bricks beside those that were found: their faces there may be seen or hidden now.
void BrickVersions::addNeighbours(glm::ivec3 sizeInBricks) {
    for (size_t i = 0, count = m_found.size(); i < count; ++i) {
        const glm::ivec3 brick = m_found[i].brick();
        for (int axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                glm::ivec3 beside = brick;
                beside[axis] += step;
                if (beside[axis] >= 0 && beside[axis] < sizeInBricks[axis]) m_found.emplace_back(beside);
            }
    }
    std::sort(m_found.begin(), m_found.end());
    m_found.erase(std::unique(m_found.begin(), m_found.end()), m_found.end());
}

}  // namespace rubble
