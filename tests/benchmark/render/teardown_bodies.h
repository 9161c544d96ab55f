#pragma once
#include <deque>
#include <vector>

#include "tests/benchmark/render/dense_grid.h"
#include "tests/benchmark/render/gbuffer_rig.h"

namespace rubble::bench {

/// The reference game's whole method for a G-buffer: a 3D texture and a draw call an object, boxes' back faces, from
/// near to far, and the linear depth copied eight times on the way.
class TeardownBodies {
public:
    explicit TeardownBodies(ShaderLibrary& shaders);
    /// As the next instance of the rig's scene.
    void add(const VoxelGrid& grid) { m_grids.emplace_back(grid); }
    /// Into the same targets as GBufferPass. order: instances in view, nearest first.
    void draw(const FrameContext& frame, const std::vector<int>& order);

private:
    static constexpr int kCopies = 8;
    const Program& m_program;
    std::deque<DenseGrid> m_grids;
};

}  // namespace rubble::bench
