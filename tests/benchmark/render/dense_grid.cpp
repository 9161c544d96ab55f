#include "tests/benchmark/render/dense_grid.h"

#include <vector>

namespace rubble::bench {
namespace {

constexpr int kLevels = 3;
constexpr int kUnit = 14;  // beyond the samplers of these programs

}  // namespace

DenseGrid::DenseGrid(const VoxelGrid& grid) : m_size((grid.size() + 3) / 4 * 4) {
    glGenTextures(1, &m_texture);
    glActiveTexture(GL_TEXTURE0 + kUnit);
    glBindTexture(GL_TEXTURE_3D, m_texture);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, kLevels - 1);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int level = 0; level < kLevels; ++level) {
        const glm::ivec3 size = m_size >> level;
        std::vector<uint8_t> cells(size_t(size.x) * size_t(size.y) * size_t(size.z));
        grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                const glm::ivec3 voxel = position * kBrickSize + voxelInBrick(i), cell = voxel >> level;
                cells[(size_t(cell.z) * size_t(size.y) + size_t(cell.y)) * size_t(size.x) + size_t(cell.x)] =
                    uint8_t(grid.at(voxel));
            });
        });
        glTexImage3D(GL_TEXTURE_3D, level, GL_R8, size.x, size.y, size.z, 0, GL_RED, GL_UNSIGNED_BYTE, cells.data());
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

DenseGrid::~DenseGrid() {
    glDeleteTextures(1, &m_texture);
}

void DenseGrid::bind(const Program& program) const {
    glActiveTexture(GL_TEXTURE0 + kUnit);
    glBindTexture(GL_TEXTURE_3D, m_texture);
    program.set("uVoxels", kUnit);
    program.set("uSize", m_size);
}

}  // namespace rubble::bench
