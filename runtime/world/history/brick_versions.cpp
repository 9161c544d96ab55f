#include "runtime/world/history/brick_versions.h"

#include <algorithm>
#include <glm/common.hpp>

namespace rubble {
namespace {

bool shinesInGroup(const Palette& palette, const std::vector<bool>& groups) {
    return std::any_of(palette.begin(), palette.end(), [&](const PaletteEntry& entry) {
        return entry.lightGroup && entry.lightGroup - 1 < groups.size() && groups[entry.lightGroup - 1];
    });
}

}  // namespace

void BrickVersions::forget() {
    m_known.clear();
    m_isOut.clear();
    m_isAsked = false;
    m_first = ++m_version;
}

BrickVersions::Known& BrickVersions::known(ShapeHandle shape) {
    if (m_known.size() <= shape.slot()) m_known.resize(shape.slot() + 1);
    Known& found = m_known[shape.slot()];
    if (found.shape != shape) found = {shape};
    return found;
}

void BrickVersions::follow(const FrameChanges& changes, const WorldData& world) {
    if (!m_isAsked) return;
    ++m_version;
    for (const ShapeHandle shape : changes.shapesCreated) {
        Known& made = known(shape);
        made = {shape, m_version};
    }
    for (const BrickChange& change : changes.bricks)
        known(change.shape).bricks.add(BrickPlace(change.brick), m_version);
    for (const ShapeHandle shape : changes.palettes) known(shape).looked = m_version;
    if (!changes.groups.empty()) followGroups(changes, world);
}

/// A group that goes out, or comes back, changes the light of all shapes with voxels of it.
void BrickVersions::followGroups(const FrameChanges& changes, const WorldData& world) {
    std::vector<bool> switched;
    for (const LightGroupHandle handle : changes.groups) {
        const LightGroup* group = world.groups.find(handle);
        const size_t slot = handle.slot();
        if (m_isOut.size() <= slot) m_isOut.resize(slot + 1);
        const bool isOut = group && group->out;
        if (isOut == m_isOut[slot]) continue;
        m_isOut[slot] = isOut;
        if (switched.size() <= slot) switched.resize(slot + 1);
        switched[slot] = true;
    }
    if (switched.empty()) return;
    world.shapes.forEach([&](ShapeHandle handle, const Shape& shape) {
        if (shinesInGroup(*shape.palette, switched)) known(handle).looked = m_version;
    });
}

const std::vector<BrickPlace>* BrickVersions::changed(const WorldData& world, ShapeHandle handle, uint64_t since,
                                                      What what) {
    const VoxelGrid& grid = world.shapes.at(handle).grid;
    if (!m_isAsked) {
        if (since) return nullptr;
        m_isAsked = true;
        world.groups.forEach([&](LightGroupHandle group, const LightGroup& each) {
            if (m_isOut.size() <= group.slot()) m_isOut.resize(group.slot() + 1);
            m_isOut[group.slot()] = each.out;
        });
    }
    m_found.clear();
    if (since == 0) {
        grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) { m_found.emplace_back(brick); });
        std::sort(m_found.begin(), m_found.end());
        return &m_found;
    }
    const Known& found = known(handle);
    if (since < std::max(m_first, found.made) || since > m_version) return nullptr;
    if (what == What::Mesh && since < found.looked) return nullptr;
    found.bricks.since(since, m_found);
    if (what == What::Mesh) addNeighbours(grid.sizeInBricks());
    return &m_found;
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
