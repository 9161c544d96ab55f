#include "samples/scenes/canvas.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "runtime/core/random.h"

namespace rubble::scenes {

void Canvas::box(ivec3 low, ivec3 high, Swatch swatch) {
    fill(low, high, [&](ivec3 cell) { return PaletteBuilder::pick(swatch, cell); });
}

void Canvas::clear(ivec3 low, ivec3 high) {
    fill(low, high, [](ivec3) { return uint8_t(0); });
}

void Canvas::stain(ivec3 low, ivec3 high, Swatch swatch, int percent) {
    fill(low, high, [&](ivec3 cell) {
        const uint8_t entry = at(cell);
        const uint32_t clump = hashCell(cell.x / 3, cell.y / 2, cell.z / 3, 21) >> 8;
        const uint32_t own = hashCell(cell.x, cell.y, cell.z, 22) >> 8;
        const int dice = int((clump % 100 + own % 100) / 2);
        return entry && dice < percent ? PaletteBuilder::pick(swatch, cell) : entry;
    });
}

void Canvas::ring(int axis, int low, int high, ivec3 doubledCenter, int doubledInner, int doubledOuter, Swatch swatch) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto first = [&](int i) { return std::max((doubledCenter[i] - doubledOuter) / 2 - 1, 0); };
    const auto last = [&](int i) { return std::min((doubledCenter[i] + doubledOuter) / 2 + 1, m_size[i] - 1); };
    for (int a = first(u); a <= last(u); ++a)
        for (int b = first(v); b <= last(v); ++b) {
            const int da = 2 * a + 1 - doubledCenter[u], db = 2 * b + 1 - doubledCenter[v];
            const int square = da * da + db * db;
            if (square > doubledOuter * doubledOuter || (doubledInner >= 0 && square <= doubledInner * doubledInner))
                continue;
            for (int h = low; h < high; ++h) {
                ivec3 cell;
                cell[axis] = h, cell[u] = a, cell[v] = b;
                set(cell, swatch);
            }
        }
}

void Canvas::bar(ivec3 from, ivec3 to, int thickness, Swatch swatch) {
    const ivec3 delta = to - from;
    const int steps = std::max({std::abs(delta.x), std::abs(delta.y), std::abs(delta.z), 1}) * 2;
    for (int i = 0; i <= steps; ++i) {
        // The corner cells of a diagonal step are drawn too, so that consecutive cells share a face.
        const ivec3 cell = from + (delta * i) / steps;
        const ivec3 next = from + (delta * std::min(i + 1, steps)) / steps;
        ivec3 walk = cell;
        for (int axis = 0; axis < 3; ++axis) {
            box(walk, walk + thickness, swatch);
            walk[axis] = next[axis];
        }
        box(walk, walk + thickness, swatch);
    }
}

void Canvas::removeUnanchored() {
    m_writer->flush();
    const std::vector<bool> anchored = anchoredCells(m_grid);
    size_t i = 0;
    for (int z = 0; z < m_size.z; ++z)
        for (int y = 0; y < m_size.y; ++y)
            for (int x = 0; x < m_size.x; ++x, ++i)
                if (!anchored[i] && at({x, y, z})) setEntry({x, y, z}, 0);
}

LevelShape Canvas::finish(std::string name) {
    m_writer->flush();
    LevelShape shape;
    shape.name = std::move(name);
    shape.grid = std::move(m_grid);
    shape.palette = m_palette.palette();
    return shape;
}

std::vector<bool> anchoredCells(const VoxelGrid& grid) {
    const ivec3 size = grid.size();
    std::vector<bool> reached(size_t(size.x) * size.y * size.z);
    std::vector<ivec3> open;
    const auto visit = [&](ivec3 cell) {
        if (!grid.contains(cell)) return;
        const size_t i = (size_t(cell.z) * size.y + cell.y) * size.x + cell.x;
        if (reached[i] || !grid.at(cell)) return;
        reached[i] = true;
        open.push_back(cell);
    };
    for (int z = 0; z < size.z; ++z)
        for (int x = 0; x < size.x; ++x) visit({x, 0, z});
    static constexpr std::array<ivec3, 6> kFaces{ivec3(1, 0, 0),  ivec3(-1, 0, 0), ivec3(0, 1, 0),
                                                 ivec3(0, -1, 0), ivec3(0, 0, 1),  ivec3(0, 0, -1)};
    while (!open.empty()) {
        const ivec3 cell = open.back();
        open.pop_back();
        for (const ivec3& face : kFaces) visit(cell + face);
    }
    return reached;
}

}  // namespace rubble::scenes
