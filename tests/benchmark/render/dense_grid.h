#pragma once
#include <glm/vec3.hpp>

#include "render/gl/program.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble::bench {

/// One object as Teardown stores it: a 3D texture of a byte a voxel with two coarser levels, padded to multiples of 4.
class DenseGrid {
public:
    /// Uploads all voxels. Needs a current GL context.
    explicit DenseGrid(const VoxelGrid& grid);
    ~DenseGrid();
    DenseGrid(const DenseGrid&) = delete;
    DenseGrid& operator=(const DenseGrid&) = delete;
    /// Sets the uniforms of shaders/dense_grid.glsl. The program must be in use.
    void bind(const Program& program) const;
    /// In voxels, with the padding.
    glm::ivec3 size() const { return m_size; }

private:
    glm::ivec3 m_size;
    GLuint m_texture = 0;
};

}  // namespace rubble::bench
