#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/shadow/shadow_lattice.h"
#include "runtime/shadow/shadow_volume.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// The cells of one shadow brick as rows along x: row y + 16 z, bit x.
using CellRows = std::array<uint16_t, kShadowBrickCells * kShadowBrickCells>;

/// Sets the cells of shadow brick `brick` that the grid's voxels occupy, by the lattice's rule. `bounds` holds all cells
/// that the grid can set.
void rasterize(const VoxelGrid& grid, const ShadowLattice& lattice, const CellBox& bounds, glm::ivec3 brick, CellRows& rows);

/// All cells of a small shape, made once a pose and then copied into each brick it touches.
class ShapeRaster {
public:
    /// False, and nothing is made, if the bounds or the grid are wider than 64.
    bool make(const VoxelGrid& grid, const ShadowLattice& lattice, const CellBox& bounds);
    void addTo(glm::ivec3 brick, CellRows& rows) const;
    bool isMade() const { return !m_rows.empty(); }
    void poseChanged() { m_rows.clear(); }
    void voxelsChanged() {
        m_rows.clear();
        m_voxels.clear();
    }

private:
    std::vector<uint64_t> m_voxels;  ///< the grid's: bit x, row y + z * height
    glm::ivec3 m_lowBrick{0}, m_bricks{0};
    std::vector<CellRows> m_rows;  ///< of the bricks from the lowest on, x first
};

ShadowWords packRows(const CellRows& rows);

}  // namespace rubble
