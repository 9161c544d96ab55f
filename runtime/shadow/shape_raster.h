#pragma once
#include <cstdint>
#include <vector>

#include "runtime/shadow/rasterize.h"

namespace rubble {

/// The voxels of a small shape as rasters read them; rebuilt when they change.
class RasterSource {
public:
    static constexpr int kMaxSize = 64;  ///< voxels on a side
    /// From a grid of at most kMaxSize voxels on a side.
    void make(const VoxelGrid& grid);
    bool isMade() const { return !m_rows.empty(); }  ///< and not cleared since
    void clear() { m_rows.clear(); }                 ///< when voxels have changed
    /// Bit x of the row at y and z.
    const uint64_t* rows() const { return m_rows.data(); }
    int height() const { return m_height; }                 ///< rows from one z to the next
    const CellBox& used() const { return m_used; }          ///< what lies outside is empty
    const CellBox& solidBox() const { return m_solidBox; }  ///< what lies in it is solid; none if its height is 0

private:
    void findOccupiedBox(glm::ivec3 size);
    void findSolidBox(glm::ivec3 size);
    std::vector<uint64_t> m_rows;  ///< of y + z * height
    int m_height = 0;
    CellBox m_used, m_solidBox;
};

/// All cells of a small shape, made once a pose: the words of each brick that it sets any in.
class ShapeRaster {
public:
    /// `bounds` holds all cells that the shape can set. False, and nothing is made, if they are too wide.
    bool make(const RasterSource& source, const ShadowCellTransform& cellTransform, const CellBox& bounds);
    bool isMade() const { return !m_brickSlots.empty(); }  ///< and not cleared since
    void clear();                                          ///< when the pose or the voxels have changed
    /// Null if it sets no cells there.
    const ShadowWords* find(glm::ivec3 brick) const;
    /// f(brick, words) for each brick in which it sets cells, by z, then y, then x.
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
    std::vector<ShadowWords> m_words;   ///< those in use first
    size_t m_used = 0;
};

}  // namespace rubble
