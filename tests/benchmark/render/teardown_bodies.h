#pragma once
#include <deque>
#include <vector>

#include "tests/benchmark/render/dense_grid.h"
#include "tests/benchmark/render/gbuffer_rig.h"

namespace rubble::bench {

/// A G-buffer as Teardown draws it: a 3D texture and a draw call for each object, the back faces of its box, from near
/// to far. The linear depth is copied eight times meanwhile, so that later objects end their rays early.
class TeardownBodies {
public:
    /// Loads the shaders.
    explicit TeardownBodies(ShaderLibrary& shaders);
    /// Adds the grid of the scene's next instance.
    void add(const VoxelGrid& grid) { m_grids.emplace_back(grid); }
    /// Draws into the targets of GBufferPass. order: instances in view, nearest first.
    void draw(const FrameContext& frame, const std::vector<int>& order);

private:
    static constexpr int kCopies = 8;
    const Program& m_program;
    std::deque<DenseGrid> m_grids;
    Texture m_depthSoFar;  ///< linear depth of what was drawn before the last copy
};

}  // namespace rubble::bench
