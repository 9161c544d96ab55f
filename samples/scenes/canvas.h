#pragma once
#include <memory>
#include <string>
#include <vector>

#include "runtime/world/level/level.h"
#include "samples/scenes/palette_builder.h"

namespace rubble::scenes {

using glm::ivec3;

/// Builds one shape: a grid and its palette, with functions that draw into the grid. Boxes exclude their high end;
/// cells outside the grid are ignored.
class Canvas {
public:
    /// An empty grid of `size` cells.
    explicit Canvas(ivec3 size) : m_size(size), m_grid(size), m_writer(std::make_unique<GridWriter>(m_grid)) {}

    /// Cells along each axis.
    ivec3 size() const { return m_size; }
    /// See PaletteBuilder::addSurface().
    Swatch addSurface(const SurfaceStyle& style, int percent = 100, uint32_t lightGroup = 0) {
        return m_palette.addSurface(style, percent, lightGroup);
    }

    /// Sets a cell to one of the swatch's entries; which one follows from the cell.
    void set(ivec3 cell, Swatch swatch) { m_writer->set(cell, PaletteBuilder::pick(swatch, cell)); }
    /// Sets a cell to a palette entry; 0 empties it.
    void setEntry(ivec3 cell, uint8_t entry) { m_writer->set(cell, entry); }
    /// Palette entry of a cell; 0 if it is empty.
    uint8_t at(ivec3 cell) const { return m_writer->at(cell); }
    /// Whether a cell has one of the swatch's entries.
    bool hasSwatch(ivec3 cell, Swatch swatch) const {
        const uint8_t entry = at(cell);
        return entry >= swatch.first && entry < swatch.first + swatch.count;
    }

    /// Fills a box.
    void box(ivec3 low, ivec3 high, Swatch swatch);
    /// Empties a box.
    void clear(ivec3 low, ivec3 high);
    /// Repaints `percent` of the solid cells of a box, in clumps.
    void stain(ivec3 low, ivec3 high, Swatch swatch, int percent);
    /// A tube or disc along an axis (0 = x), from low to high (exclusive): the cells with inner < distance <= outer.
    /// Centre and radii are doubled, so that even widths have a centre; an inner radius of -1 makes it solid.
    void ring(int axis, int low, int high, ivec3 doubledCenter, int doubledInner, int doubledOuter, Swatch swatch);
    /// A straight bar between two cells, face-connected, thickness cells thick.
    void bar(ivec3 from, ivec3 to, int thickness, Swatch swatch);
    /// Sets every cell of a box to f(cell), a palette entry.
    template <class F>
    void fill(ivec3 low, ivec3 high, F&& f) {
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y)
                for (int x = low.x; x < high.x; ++x) m_writer->set({x, y, z}, f(ivec3(x, y, z)));
    }

    /// Empties the cells that are not connected through faces to the bottom layer.
    void removeUnanchored();
    /// The finished shape; the canvas is empty afterwards.
    LevelShape finish(std::string name);

private:
    ivec3 m_size;
    VoxelGrid m_grid;
    std::unique_ptr<GridWriter> m_writer;
    PaletteBuilder m_palette;
};

/// For every cell of a grid, at index x + sx * (y + sy * z): whether it is connected through faces to the bottom layer.
std::vector<bool> anchoredCells(const VoxelGrid& grid);

}  // namespace rubble::scenes
