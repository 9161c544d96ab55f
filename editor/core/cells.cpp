#include "editor/core/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <span>

#include "editor/core/arguments.h"

namespace editor {
namespace {

constexpr int kTile = 64;  ///< cells along each side of what is read and written at a time

rubble_voxel_box voxelBox(rubble_shape shape, const Cells& box) {
    rubble_voxel_box out{};
    out.struct_size = sizeof out;
    out.what = RUBBLE_VOXEL_INDEX;
    out.shape = shape;
    for (int a = 0; a < 3; ++a) out.low[a] = box.low[a], out.size[a] = box.size[a];
    return out;
}

/// Calls f(cell, place) for all cells of a box; places are as in readCells().
template <class F>
void forEachCell(const Cells& box, F&& f) {
    size_t place = 0;
    for (int z = 0; z < box.size.z; ++z)
        for (int y = 0; y < box.size.y; ++y)
            for (int x = 0; x < box.size.x; ++x) f(box.low + glm::ivec3(x, y, z), place++);
}

}  // namespace

Cells between(glm::ivec3 a, glm::ivec3 b) {
    return {glm::min(a, b), glm::max(a, b) - glm::min(a, b) + 1};
}

Cells joined(const Cells& a, const Cells& b) {
    if (a.isEmpty()) return b;
    if (b.isEmpty()) return a;
    const glm::ivec3 low = glm::min(a.low, b.low);
    return {low, glm::max(a.low + a.size, b.low + b.size) - low};
}

Cells shared(const Cells& a, const Cells& b) {
    const glm::ivec3 low = glm::max(a.low, b.low);
    return {low, glm::max(glm::min(a.low + a.size, b.low + b.size) - low, glm::ivec3(0))};
}

Cells gridOf(const rubble::World& world, rubble_shape shape) {
    const rubble_shape_state state = world.get_shape_state(shape);
    return {glm::ivec3(0), {state.size[0], state.size[1], state.size[2]}};
}

std::vector<uint8_t> readCells(const rubble::World& world, rubble_shape shape, const Cells& box) {
    if (box.count() > kMaxCells)
        throw Refused(fmt::format("expected at most {} cells at a time, found {}", kMaxCells, box.count()));
    return box.isEmpty() ? std::vector<uint8_t>() : world.read_voxels(voxelBox(shape, box));
}

Cells solidOf(const rubble::World& world, rubble_shape shape) {
    Cells solid;
    forEachLayer(world, shape, gridOf(world, shape), [&](const Cells& layer, const std::vector<uint8_t>& voxels) {
        const auto isSolid = [](uint8_t voxel) { return voxel != 0; };
        for (int y = 0; y < layer.size.y; ++y) {
            const std::span row(voxels.data() + size_t(y) * size_t(layer.size.x), size_t(layer.size.x));
            const auto first = std::ranges::find_if(row, isSolid);
            if (first == row.end()) continue;
            const auto last = std::find_if(row.rbegin(), row.rend(), isSolid);
            solid = joined(solid, between(layer.low + glm::ivec3(first - row.begin(), y, 0),
                                          layer.low + glm::ivec3(row.rend() - last - 1, y, 0)));
        }
    });
    return solid;
}

CellSet connectedCells(const rubble::World& world, rubble_shape shape, glm::ivec3 start) {
    const Cells grid = gridOf(world, shape);
    if (!grid.contains(start))
        throw Refused(fmt::format("expected a cell within the shape's grid of {},{},{}, found {},{},{}", grid.size.x,
                                  grid.size.y, grid.size.z, start.x, start.y, start.z));
    const std::vector<uint8_t> voxels = readCells(world, shape, grid);
    CellSet set{shape, grid.low, grid.size, std::vector<uint8_t>(voxels.size())};
    const uint8_t index = voxels[set.at(start)];
    std::vector<glm::ivec3> line{start};
    set.mask[set.at(start)] = 1;
    while (!line.empty()) {
        const glm::ivec3 cell = line.back();
        line.pop_back();
        for (int side = 0; side < 6; ++side) {
            glm::ivec3 next = cell;
            next[side / 2] += side % 2 ? 1 : -1;
            if (!grid.contains(next) || set.mask[set.at(next)] || voxels[set.at(next)] != index) continue;
            set.mask[set.at(next)] = 1;
            line.push_back(next);
        }
    }
    return set;
}

CellWriter::CellWriter(rubble::World& world, rubble_shape shape)
    : m_world(world), m_shape(shape), m_grid(gridOf(world, shape)) {}

void CellWriter::makeRoom(const Cells& box) {
    const Cells grid = joined(m_grid, box);
    if (grid.low == m_grid.low && grid.size == m_grid.size) return;
    rubble_resize resize{};
    resize.shape = m_shape;
    for (int a = 0; a < 3; ++a) resize.low[a] = grid.low[a] - m_grid.low[a], resize.size[a] = grid.size[a];
    m_world.resize_shape(resize);
    m_world.apply_edits();  // writes are checked against the grid as it is
    m_grid = grid;
}

void CellWriter::write(const Cells& box, const std::function<uint8_t(glm::ivec3, uint8_t)>& change) {
    const Cells inside = shared(box, m_grid);
    for (int z = 0; z < inside.size.z; z += kTile)
        for (int y = 0; y < inside.size.y; y += kTile)
            for (int x = 0; x < inside.size.x; x += kTile) {
                const glm::ivec3 at(x, y, z);
                writeTile({inside.low + at, glm::min(inside.size - at, glm::ivec3(kTile))}, change);
            }
}

void CellWriter::writeTile(const Cells& tile, const std::function<uint8_t(glm::ivec3, uint8_t)>& change) {
    const Cells now{tile.low - m_grid.low, tile.size};
    std::vector<uint8_t> voxels = readCells(m_world, m_shape, now);
    std::vector<uint8_t> mask(voxels.size());
    bool isChanged = false;
    forEachCell(tile, [&](glm::ivec3 cell, size_t place) {
        const uint8_t after = change(cell, voxels[place]);
        if (after == voxels[place]) return;
        voxels[place] = after;
        mask[place] = 1;
        isChanged = true;
    });
    if (!isChanged) return;
    rubble_voxel_box box = voxelBox(m_shape, now);
    box.mask = mask.data();
    m_world.write_voxels(box, voxels.data(), voxels.size());
}

}  // namespace editor
