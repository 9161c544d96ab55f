#pragma once
#include <string>

#include "runtime/world/level/level.h"
#include "samples/scenes/palette_builder.h"

namespace rubble::scenes {

using glm::ivec3;

/// One shape in the making: a grid, its palette, and a few ways to draw into it. Boxes exclude their high end.
class Canvas {
public:
    explicit Canvas(ivec3 size) : m_size(size), m_grid(size), m_writer(std::make_unique<GridWriter>(m_grid)) {}

    ivec3 size() const { return m_size; }
    Swatch addSurface(const SurfaceStyle& style, int percent = 100, uint32_t lightGroup = 0) {
        return m_palette.addSurface(style, percent, lightGroup);
    }

    void set(ivec3 cell, Swatch swatch) { m_writer->set(cell, PaletteBuilder::pick(swatch, cell)); }
    void setEntry(ivec3 cell, uint8_t entry) { m_writer->set(cell, entry); }
    uint8_t at(ivec3 cell) const { return m_writer->at(cell); }
    bool holds(ivec3 cell, Swatch swatch) const {
        const uint8_t entry = at(cell);
        return entry >= swatch.first && entry < swatch.first + swatch.count;
    }

    void box(ivec3 low, ivec3 high, Swatch swatch);
    void clear(ivec3 low, ivec3 high);
    /// Repaints what is solid in the box, a share of it in percent, by clumps.
    void stain(ivec3 low, ivec3 high, Swatch swatch, int percent);
    /// An upright tube or disc around centre/2 (doubled coordinates, so that even widths have a centre), radius/2.
    /// Cells with inner < distance <= outer.
    void ring(int axis, int low, int high, ivec3 doubledCenter, int doubledInner, int doubledOuter, Swatch swatch);
    /// A straight bar between two cells, face-connected, thickness cells thick.
    void bar(ivec3 from, ivec3 to, int thickness, Swatch swatch);
    /// f(cell) -> palette entry, for every cell of the box.
    template <class F>
    void fill(ivec3 low, ivec3 high, F&& f) {
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y)
                for (int x = low.x; x < high.x; ++x) m_writer->set({x, y, z}, f(ivec3(x, y, z)));
    }

    /// Removes what is not joined through faces to the bottom layer.
    void removeUnanchored();
    /// The finished shape; the canvas is empty afterwards.
    LevelShape finish(std::string name);

private:
    ivec3 m_size;
    VoxelGrid m_grid;
    std::unique_ptr<GridWriter> m_writer;
    PaletteBuilder m_palette;
};

/// For every cell of a grid (x + sx * (y + sy * z)): is it joined through faces to a solid cell of the bottom layer?
std::vector<bool> anchoredCells(const VoxelGrid& grid);

}  // namespace rubble::scenes
