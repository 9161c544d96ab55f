#pragma once
#include <cstdint>
#include <vector>

#include "runtime/shadow/rasterize.h"

namespace rubble {

/// The voxels of a small shape as rows of bits, for ShapeRaster. Built again when they change.
class RasterSource {
public:
    static constexpr int kMaxSize = 64;  ///< voxels on a side
    /// Builds it. No side of the grid may be longer than kMaxSize.
    void make(const VoxelGrid& grid);
    /// Whether it has been built and not cleared.
    bool isMade() const { return !m_rows.empty(); }
    /// Forgets the voxels.
    void clear() { m_rows.clear(); }
    /// The rows, at index y + z * height(): bit x is a voxel.
    const uint64_t* rows() const { return m_rows.data(); }
    int height() const { return m_height; }                 ///< number of rows per z
    const CellBox& used() const { return m_used; }          ///< box around all voxels
    const CellBox& solidBox() const { return m_solidBox; }  ///< a large box that is solid throughout; may be empty

private:
    void findOccupiedBox(glm::ivec3 size);
    void findSolidBox(glm::ivec3 size);
    std::vector<uint64_t> m_rows;  ///< of y + z * height
    int m_height = 0;
    CellBox m_used, m_solidBox;
};

/// All shadow cells of a small shape in one pose, as words by brick.
class ShapeRaster {
public:
    /// Builds it. bounds: a box that contains all cells that the shape can set. False, and it is empty, if they are
    /// more than 60 cells along an axis.
    bool make(const RasterSource& source, const ShadowCellTransform& cellTransform, const CellBox& bounds);
    /// Whether it has been built and not cleared.
    bool isMade() const { return !m_brickSlots.empty(); }
    /// Forgets all cells.
    void clear();
    /// The cells of a brick; null if the shape sets none there.
    const ShadowWords* find(glm::ivec3 brick) const;
    /// Calls f(brick, words) for each brick with cells, in the order of z, then y, then x.
    template <class F>
    void forEach(F&& f) const {
        for (size_t i = 0; i < m_brickSlots.size(); ++i)
            if (m_brickSlots[i]) f(brickAt(int(i)), m_words[m_brickSlots[i] - 1u]);
    }

private:
    ShadowWords& wordsAt(size_t index);
    glm::ivec3 brickAt(int i) const {
        return m_lowBrick + glm::ivec3(i % m_bricks.x, i / m_bricks.x % m_bricks.y, i / m_bricks.x / m_bricks.y);
    }
    glm::ivec3 m_lowBrick{0}, m_bricks{0};
    std::vector<uint8_t> m_brickSlots;  ///< for each brick of the box, x first: its place in m_words plus one
    std::vector<ShadowWords> m_words;
};

}  // namespace rubble
